# tricontact_sources_digest(target header function source...): a unit of the target that defines
# `std::string_view tricontact::<function>()`, which `header` declares: a digest of the sources, whose
# paths are relative to the project's root. Made when they change; only that unit is compiled then.
function(tricontact_sources_digest target header function)
    set(sources ${ARGN})
    list(SORT sources)
    list(REMOVE_DUPLICATES sources)
    list(JOIN sources "\n" lines)
    string(REPLACE "::" "_" name ${function})
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${name}.txt)
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/${name}.cc)
    file(CONFIGURE OUTPUT ${list} CONTENT "${lines}\n" @ONLY)
    set(script ${PROJECT_SOURCE_DIR}/cmake/sources_digest.cmake)
    list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/)
    add_custom_command(OUTPUT ${unit}
        COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DLIST=${list} -DUNIT=${unit}
                -DHEADER=${header} -DFUNCTION=${function} -P ${script}
        DEPENDS ${sources} ${list} ${script}
        COMMENT "Digest of the sources for ${function}" VERBATIM)
    target_sources(${target} PRIVATE ${unit})
    set_source_files_properties(${unit} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# tricontact_sources_of(variable folder...): all sources of these folders, without their subfolders.
function(tricontact_sources_of variable)
    set(found "")
    foreach(folder IN LISTS ARGN)
        file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
             ${PROJECT_SOURCE_DIR}/${folder}/*.cc ${PROJECT_SOURCE_DIR}/${folder}/*.h)
        list(APPEND found ${sources})
    endforeach()
    set(${variable} ${found} PARENT_SCOPE)
endfunction()
