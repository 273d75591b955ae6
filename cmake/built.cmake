# Run first of all by `cmake --install` and by cpack: what is not built is named and left out, and without the program
# nothing is begun. Targets that come later are known by the time the expressions are evaluated.
install(CODE "
if(NOT EXISTS \"$<TARGET_FILE:tricontact>\")
    message(FATAL_ERROR \"The program is not built: nothing is installed or packed. Build all of it, cmake --build ${PROJECT_BINARY_DIR}, or the program alone, with --target tricontact\")
endif()")
set(further "${PROJECT_BINARY_DIR}/manual/tricontact.1" "manual page and completions of shells (target manual)")
if(TRICONTACT_WITH_PYTHON)
    list(APPEND further "$<TARGET_FILE:tricontact_python>" "the module for Python (target tricontact_python)")
endif()
while(further)
    list(POP_FRONT further file what)
    install(CODE "
if(NOT EXISTS \"${file}\")
    message(NOTICE \"Left out, as it is not built: ${what}. cmake --build ${PROJECT_BINARY_DIR} builds all\")
endif()")
endwhile()
