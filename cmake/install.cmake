# What `cmake --install` puts beside program, libraries, headers and Python's module: how other
# projects find them, and the examples.

include(CMakePackageConfigHelpers)
set(documents ${CMAKE_INSTALL_DATADIR}/doc/tricontact)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Tricontact)

install(EXPORT Tricontact FILE TricontactTargets.cmake NAMESPACE Tricontact::
        DESTINATION ${package_folder} COMPONENT development)
if(TRICONTACT_WITH_FEM)
    install(EXPORT TricontactFem FILE TricontactFemTargets.cmake NAMESPACE Tricontact::
            DESTINATION ${package_folder} COMPONENT development)
endif()
configure_package_config_file(cmake/TricontactConfig.cmake.in
    ${PROJECT_BINARY_DIR}/TricontactConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TricontactConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/TricontactConfig.cmake
              ${PROJECT_BINARY_DIR}/TricontactConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)

install(DIRECTORY examples
        DESTINATION ${CMAKE_INSTALL_DATADIR}/tricontact)
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${documents})
install(DIRECTORY docs DESTINATION ${documents} PATTERN conf.py EXCLUDE)
