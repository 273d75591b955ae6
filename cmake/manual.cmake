# Manual page and completions of shells, as the program prints them from the declarations of its options.
include(GNUInstallDirs)
set(manual ${PROJECT_BINARY_DIR}/manual)
set(manual_files)
# add_manual(kind file folder): what `tricontact manual kind` prints.
function(add_manual kind file)
    add_custom_command(OUTPUT ${manual}/${file} DEPENDS tricontact
        COMMAND ${CMAKE_COMMAND} -E make_directory ${manual}
        COMMAND tricontact manual ${kind} > ${manual}/${file} VERBATIM)
    set(manual_files ${manual_files} ${manual}/${file} PARENT_SCOPE)
    foreach(folder ${ARGN})
        install(FILES ${manual}/${file} DESTINATION ${folder} OPTIONAL)
    endforeach()
endfunction()
add_manual(man tricontact.1 ${CMAKE_INSTALL_MANDIR}/man1)
add_manual(bash tricontact ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
# Where zsh looks below /usr/local, and Debian's below /usr.
add_manual(zsh _tricontact ${CMAKE_INSTALL_DATADIR}/zsh/site-functions ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
add_manual(fish tricontact.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
add_custom_target(manual ALL DEPENDS ${manual_files})
