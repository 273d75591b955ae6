# What every target shares: warnings, include root, and a helper that makes one library per folder.

include(GNUInstallDirs)
include(CheckLinkerFlag)

# The libraries behind deal.II cost the default linker fifteen seconds per program, this one a second.
check_linker_flag(CXX -fuse-ld=gold TRICONTACT_HAS_GOLD)
if(TRICONTACT_HAS_GOLD)
    add_link_options(-fuse-ld=gold)
endif()

add_library(tricontact_settings INTERFACE)
target_include_directories(tricontact_settings INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/tricontact>)
target_compile_features(tricontact_settings INTERFACE cxx_std_20)
target_compile_options(tricontact_settings INTERFACE
    $<BUILD_INTERFACE:-Wall> $<BUILD_INTERFACE:-Wextra> $<BUILD_INTERFACE:-Wpedantic>
    $<BUILD_INTERFACE:-Wshadow>
    # Members that an initialiser by names leaves out have their defaults. Units compiled together stand in a
    # file of their own, where GCC takes anonymous names for those of a header.
    $<BUILD_INTERFACE:-Wno-missing-field-initializers>
    $<$<CXX_COMPILER_ID:GNU>:$<BUILD_INTERFACE:-Wno-subobject-linkage>>
    # Same source, same bytes: no contraction into fused multiply-adds by the compiler's choice.
    $<BUILD_INTERFACE:-ffp-contract=off>)
set_target_properties(tricontact_settings PROPERTIES EXPORT_NAME settings)
install(TARGETS tricontact_settings EXPORT Tricontact)

# tricontact_compile_together(room unit...): units of one room, sixteen at a time: most of a unit's time goes into
# the headers that it includes. Names in anonymous namespaces are therefore unique within a room.
function(tricontact_compile_together room)
    set(n 0)
    foreach(unit IN LISTS ARGN)
        math(EXPR group "${n} / 16")
        string(MAKE_C_IDENTIFIER "${room}_${group}" group)
        set_source_files_properties(${unit} PROPERTIES UNITY_GROUP ${group})
        math(EXPR n "${n} + 1")
    endforeach()
endfunction()

# tricontact_library(name ROOMS ... DEPENDS ...): target tricontact_<name> of all units in the current folder
# and these of its subfolders, but for those of EXCEPT; installed with their headers for other projects as
# Tricontact::<name>; those that need the finite elements' packages with the option FEM. PROGRAM_ONLY: not
# installed. TEXT: reads, writes and lays out; optimised less, which compiles in two thirds of the time. LOOPS: its
# time goes into loops over points; optimised more.
function(tricontact_library name)
    cmake_parse_arguments(ARG "FEM;PROGRAM_ONLY;TEXT;LOOPS" "" "ROOMS;EXCEPT;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    list(TRANSFORM ARG_EXCEPT PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    add_library(tricontact_${name} STATIC)
    foreach(room IN ITEMS . LISTS ARG_ROOMS)
        file(GLOB units CONFIGURE_DEPENDS ${room}/*.cc)
        list(TRANSFORM units REPLACE "/\\./" "/")
        list(REMOVE_ITEM units ${ARG_EXCEPT})
        target_sources(tricontact_${name} PRIVATE ${units})
        tricontact_compile_together(${room} ${units})
    endforeach()
    set_target_properties(tricontact_${name} PROPERTIES UNITY_BUILD_MODE GROUP)
    target_link_libraries(tricontact_${name} PUBLIC tricontact_settings ${ARG_DEPENDS}
                                             PRIVATE ${ARG_PRIVATE_DEPENDS})
    if(ARG_TEXT)
        target_compile_options(tricontact_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    elseif(ARG_LOOPS)
        target_compile_options(tricontact_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
    endif()
    if(ARG_PROGRAM_ONLY)
        return()
    endif()
    set(export Tricontact)
    if(ARG_FEM)
        set(export TricontactFem)
    endif()
    set_target_properties(tricontact_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS tricontact_${name} EXPORT ${export} DESTINATION ${CMAKE_INSTALL_LIBDIR}
            COMPONENT development)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
    foreach(room IN ITEMS . LISTS ARG_ROOMS)
        file(GLOB headers CONFIGURE_DEPENDS ${room}/*.h)
        install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tricontact/${folder}/${room}
                COMPONENT development)
    endforeach()
endfunction()

# tricontact_precompile(target header...): what most of its files include, compiled once. A compiler cache serves
# better, and does not know what precompiled headers hold.
function(tricontact_precompile target)
    if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
        target_precompile_headers(${target} PRIVATE ${ARGN})
    endif()
endfunction()

# tricontact_precompile_as(target other): the same headers as those of another target, which have to be compiled
# with no definition that this one lacks.
function(tricontact_precompile_as target other)
    if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
        target_precompile_headers(${target} REUSE_FROM ${other})
    endif()
endfunction()

# tricontact_precompile_texts(target): what all that writes text and JSON includes, compiled once for all of them.
function(tricontact_precompile_texts target)
    if(NOT TARGET tricontact_text_headers)
        file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/text_headers.cc CONTENT "")
        add_library(tricontact_text_headers OBJECT ${PROJECT_BINARY_DIR}/text_headers.cc)
        target_link_libraries(tricontact_text_headers
            PRIVATE tricontact_settings fmt::fmt nlohmann_json::nlohmann_json)
        tricontact_precompile(tricontact_text_headers <fmt/format.h> <nlohmann/json.hpp>)
    endif()
    tricontact_precompile_as(${target} tricontact_text_headers)
endfunction()
