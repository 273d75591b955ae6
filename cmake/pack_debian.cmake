# Run by cpack: debian/rules on a copy of debian/, with the finished build. The package goes where cpack says.
find_program(dh dh)
if(NOT dh)
    message(FATAL_ERROR "dh, which makes the Debian package, is not there: install debhelper and dh-python")
endif()
set(work ${CPACK_TEMPORARY_DIRECTORY}/source)
file(REMOVE_RECURSE ${work})
file(COPY ${CPACK_TRICONTACT_SOURCE}/debian DESTINATION ${work})
set(made ${CPACK_TEMPORARY_DIRECTORY}/made)
file(REMOVE_RECURSE ${made})
file(MAKE_DIRECTORY ${made})
execute_process(COMMAND ${CMAKE_COMMAND} -E env TRICONTACT_BUILD=${CPACK_TRICONTACT_BUILD} TRICONTACT_PACKAGES=${made}
                        debian/rules binary
                WORKING_DIRECTORY ${work} RESULT_VARIABLE code
                OUTPUT_FILE ${CPACK_TEMPORARY_DIRECTORY}/log ERROR_FILE ${CPACK_TEMPORARY_DIRECTORY}/log)
if(code)
    file(READ ${CPACK_TEMPORARY_DIRECTORY}/log log)
    message(FATAL_ERROR "debian/rules failed:\n${log}")
endif()
file(GLOB CPACK_EXTERNAL_BUILT_PACKAGES ${made}/*.deb)
