# What cpack makes: the Debian package of debian/, from this build folder instead of a new one. One place says what is
# in it and what it needs: debian/control and debian/rules.

set(CPACK_GENERATOR External)
set(CPACK_PACKAGE_NAME tricontact)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_EXTERNAL_PACKAGE_SCRIPT ${PROJECT_SOURCE_DIR}/cmake/pack_debian.cmake)
set(CPACK_TRICONTACT_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_TRICONTACT_BUILD ${PROJECT_BINARY_DIR})
include(CPack)
