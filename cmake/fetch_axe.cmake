# cmake -DFOLDER=path -P fetch_axe.cmake: unpacks axe-core, MPL 2.0, into FOLDER/package: rules of accessible pages, by which
# check_report.sh judges reports. No part of the program.
include(${CMAKE_CURRENT_LIST_DIR}/npm_packages.cmake)
fetch_npm_package(axe-core 4.14.1
    1477dafa598d8d065f273d6af302aa203c02e83131707b7fa648cd41bd3d6b734f8c22a0dab86ee6a6f64b8afbe804b214d36db85a2826965edfb3a0b9d546b5
    OPTION TRICONTACT_AXE FOLDER ${FOLDER})
