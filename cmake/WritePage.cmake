# Writes what a program prints, called with some words, to a file: program with the one that runs it, words, file.
get_filename_component(folder ${file} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${program} ${words} OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
