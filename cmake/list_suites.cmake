# Writes TESTS, read by CTest: the suites of PROGRAM with PROPERTIES.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[^ \n]+\\.[ \n]" suites "\n${listed}")
set(text "")
foreach(suite IN LISTS suites)
    string(REGEX REPLACE "^\n(.+)\\..$" "\\1" suite "${suite}")
    string(APPEND text "add_test([==[${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==])\n"
           "set_tests_properties([==[${suite}]==] PROPERTIES")
    foreach(word IN LISTS PROPERTIES)
        string(APPEND text " [==[${word}]==]")
    endforeach()
    string(APPEND text ")\n")
endforeach()
file(WRITE ${TESTS} "${text}")
