# adore_install_app(<name>): the program, its manual page and completion, its entry in the desktop's menu, and its icon.
include(GNUInstallDirs)
function(adore_install_app name)
  install(TARGETS ${name})
  adore_command_line_files(${name})
  install(FILES ${CMAKE_SOURCE_DIR}/resources/applications/${name}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/${name}.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/${name}.png DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/128x128/apps)
endfunction()
