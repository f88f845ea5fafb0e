# adore_command_line_files(<program> <component>): its manual page and the completion of bash, zsh and fish, written by the program
# itself from its tree of commands, and installed where those look for them.
include(GNUInstallDirs)
function(adore_command_line_files program component)
  set(folder ${CMAKE_BINARY_DIR}/command_line)
  file(MAKE_DIRECTORY ${folder})
  set(page ${folder}/${program}.1)
  set(bash ${folder}/${program}.bash)
  set(zsh ${folder}/_${program})
  set(fish ${folder}/${program}.fish)
  add_custom_command(
    OUTPUT ${page} ${bash} ${zsh} ${fish}
    COMMAND ${program} --man > ${page}
    COMMAND ${program} --completion bash > ${bash}
    COMMAND ${program} --completion zsh > ${zsh}
    COMMAND ${program} --completion fish > ${fish}
    DEPENDS ${program} COMMENT "Writing manual page and completion of ${program}" VERBATIM)
  add_custom_target(${program}_command_line_files ALL DEPENDS ${page} ${bash} ${zsh} ${fish})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
  install(FILES ${bash} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program}
          COMPONENT ${component})
  set(zsh_folder site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(zsh_folder vendor-completions)  # where Debian's packages have them
  endif()
  install(FILES ${zsh} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh_folder} COMPONENT ${component})
  install(FILES ${fish} DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT ${component})
endfunction()
