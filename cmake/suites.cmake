# tricontact_discover_suites(target together long property value...): a test of CTest for so many suites of a program made
# with GoogleTest, one after another in one process, named Suite+Suite+...: `ctest -R Suite` finds it. A process per
# suite would start the program six hundred times more often, of finite elements .3 s each: a tenth of all fast tests.
# Suites of the list `long` are tests of their own, and those named ...Slow, whose label is slow.
function(tricontact_discover_suites target together long)
    set(tests ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
    if(NOT EXISTS ${tests})
        file(WRITE ${tests} "add_test(${target}_not_built ${target}_not_built)\n")
    endif()
    string(REPLACE ";" "|" long "${long}")
    add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${tests}
        COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DTESTS=${tests} -DTOGETHER=${together}
                "-DLONG=${long}"
                "-DPROPERTIES=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake
        VERBATIM)
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${tests})
endfunction()
