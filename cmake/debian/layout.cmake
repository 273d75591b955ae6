# Run by cpack on what is to be packed: Debian's interpreter looks for modules of packages in
# /usr/lib/python3, not in the folder of its version as below /usr/local.
file(GLOB versioned ${CPACK_TEMPORARY_DIRECTORY}/*/usr/lib/python3.*)
foreach(folder ${versioned})
    get_filename_component(lib ${folder} DIRECTORY)
    file(RENAME ${folder} ${lib}/python3)
endforeach()
