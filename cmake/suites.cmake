# tricontact_discover_suites(target property value...): one test of CTest for every suite of a program made
# with GoogleTest. A process per case, as gtest_discover_tests has it, would start the program a thousand times
# more often: a quarter of the time of all fast tests.
function(tricontact_discover_suites target)
    set(tests ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
    if(NOT EXISTS ${tests})
        file(WRITE ${tests} "add_test(${target}_not_built ${target}_not_built)\n")
    endif()
    add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${tests}
        COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DTESTS=${tests}
                "-DPROPERTIES=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake
        VERBATIM)
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${tests})
endfunction()
