# The manual page and the completion of the shells, printed by the program that was built, and installed.
set(ljmd_pages ${PROJECT_BINARY_DIR}/pages)
set(ljmd_page_files "")
foreach(page "ljmd.1,help,--man" "bash/ljmd,completion,bash" "fish/ljmd.fish,completion,fish" "zsh/_ljmd,completion,zsh")
    string(REPLACE "," ";" words ${page})
    list(POP_FRONT words file)
    list(APPEND ljmd_page_files ${ljmd_pages}/${file})
    add_custom_command(OUTPUT ${ljmd_pages}/${file}
                       COMMAND ${CMAKE_COMMAND} -D "program=${CMAKE_CROSSCOMPILING_EMULATOR};$<TARGET_FILE:ljmd>" -D "words=${words}"
                               -D "file=${ljmd_pages}/${file}" -P ${PROJECT_SOURCE_DIR}/cmake/WritePage.cmake
                       DEPENDS ljmd cmake/WritePage.cmake VERBATIM)
endforeach()
add_custom_target(ljmd_pages ALL DEPENDS ${ljmd_page_files})

install(FILES ${ljmd_pages}/ljmd.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${ljmd_pages}/bash/ljmd DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${ljmd_pages}/fish/ljmd.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${ljmd_pages}/zsh/_ljmd DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
