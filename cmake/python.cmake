# For which interpreter the module is, and where it is installed. Debian's, unless another one is
# named: the packages bring NumPy for that one.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Interpreter that the module is for")
endif()
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
# dist-packages on Debian, else site-packages: where the interpreter looks below /usr/local.
get_filename_component(python_packages ${Python_SITEARCH} NAME)
set(TRICONTACT_PYTHON_DIR
    lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/${python_packages}
    CACHE STRING "Folder of the Python module, below the prefix")
