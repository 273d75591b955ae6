# What cpack makes: a Debian package of the program, Python's module, documents and cases. Built on the
# Debian it is for, whose libraries dpkg-shlibdeps finds; no development files, which conflict with ParaView.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tricontact)
set(CPACK_PACKAGE_CONTACT "The developers of Tricontact")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Only what users of the program need: libraries and headers for other projects stay out.
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tricontact)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"Computes a body that is pressed on an elastic layer, loaded tangentially and
rolled, by several independent models from one case file, and states how far
they differ. With a module for Python, documents and example cases.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(TRICONTACT_WITH_PYTHON)
    math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PACKAGE_DEPENDS
        "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, fontconfig, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "paraview, python3-xarray, python3-pandas, python3-matplotlib, python3-pint")
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/layout.cmake)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
include(CPack)
