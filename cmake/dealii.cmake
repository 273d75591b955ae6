# tricontact_dealii: deal.II's release library with its headers as system headers.
# deal_ii_initialize_cached_variables() is not called: it would set the build type.
find_package(deal.II 9.4 REQUIRED)
include(${DEAL_II_TARGET_CONFIG})
if(NOT TARGET tricontact_dealii)
    add_library(tricontact_dealii INTERFACE)
    target_link_libraries(tricontact_dealii INTERFACE ${DEAL_II_TARGET_RELEASE})
    target_include_directories(tricontact_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
    # Debugging symbols of its templates need more memory than the code.
    target_compile_options(tricontact_dealii INTERFACE -g0)
    set_target_properties(tricontact_dealii PROPERTIES EXPORT_NAME dealii)
    install(TARGETS tricontact_dealii EXPORT TricontactFem)
endif()
