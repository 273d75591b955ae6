# What every target shares: warnings, include root, and a helper that makes one library per folder.

add_library(tricontact_settings INTERFACE)
target_include_directories(tricontact_settings INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(tricontact_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
# Same source, same bytes: no contraction into fused multiply-adds behind the reader's back.
target_compile_options(tricontact_settings INTERFACE -ffp-contract=off)

# tricontact_library(name SOURCES ... DEPENDS ...): target tricontact_<name> from the current folder.
function(tricontact_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    add_library(tricontact_${name} STATIC ${ARG_SOURCES})
    target_link_libraries(tricontact_${name} PUBLIC tricontact_settings ${ARG_DEPENDS}
                                             PRIVATE ${ARG_PRIVATE_DEPENDS})
endfunction()
