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

# tricontact_units_of(variable unit...): source and header of each of these, one of both at least.
function(tricontact_units_of variable)
    set(found "")
    foreach(unit IN LISTS ARGN)
        set(files "")
        foreach(file ${unit}.cc ${unit}.h)
            if(EXISTS ${PROJECT_SOURCE_DIR}/${file})
                list(APPEND files ${file})
            endif()
        endforeach()
        if(NOT files)
            message(FATAL_ERROR "${unit}: there is no such unit, for the digest of ${variable}")
        endif()
        list(APPEND found ${files})
    endforeach()
    set(${variable} ${found} PARENT_SCOPE)
endfunction()

# tricontact_linked_folders(variable target...): top folders of these libraries of the project, where they are there, and of
# all of the project's that they link.
function(tricontact_linked_folders variable)
    set(folders "")
    set(waiting ${ARGN})
    set(seen "")
    while(waiting)
        list(POP_FRONT waiting target)
        if(target IN_LIST seen OR NOT TARGET ${target} OR NOT target MATCHES "^tricontact_")
            continue()
        endif()
        list(APPEND seen ${target})
        get_target_property(kind ${target} TYPE)
        if(NOT kind STREQUAL "STATIC_LIBRARY")
            continue()  # settings, headers of others
        endif()
        get_target_property(folder ${target} SOURCE_DIR)
        file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
        string(REGEX REPLACE "/.*" "" folder ${folder})
        list(APPEND folders ${folder})
        get_target_property(linked ${target} LINK_LIBRARIES)
        list(APPEND waiting ${linked})
    endwhile()
    list(REMOVE_DUPLICATES folders)
    set(${variable} ${folders} PARENT_SCOPE)
endfunction()
