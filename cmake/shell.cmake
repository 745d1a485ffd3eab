# What a shell and `man` need to know the program, printed by itself.
add_custom_command(OUTPUT arenite.1 arenite.bash _arenite arenite.fish
  COMMAND arenite man > arenite.1
  COMMAND arenite completion bash > arenite.bash
  COMMAND arenite completion zsh > _arenite
  COMMAND arenite completion fish > arenite.fish
  DEPENDS arenite VERBATIM)
add_custom_target(man ALL DEPENDS arenite.1)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/arenite.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/arenite.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME arenite)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/_arenite DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/arenite.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
