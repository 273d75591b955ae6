# tricontact_templates(target unit.cc.in [VARIABLE file]...): a unit of the target, made from unit.cc.in, in which
# @VARIABLE@ stands for the text of the file.
function(tricontact_templates target unit)
    while(ARGN)
        list(POP_FRONT ARGN variable file)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} ${variable})
    endwhile()
    string(REGEX REPLACE "\\.in$" "" made ${CMAKE_CURRENT_BINARY_DIR}/${unit})
    configure_file(${unit} ${made} @ONLY)
    target_sources(${target} PRIVATE ${made})
endfunction()
