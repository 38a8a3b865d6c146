# Installs the build into a fresh folder and copies the consumers and the examples of the documentation beside it. The
# installed tree is moved once: it must not remember where it was put first. With it the source tree's own copies play
# no part any more.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE ${work_dir})
set(install sh -c "umask 077 && exec \"$0\" \"$@\"" ${CMAKE_COMMAND} --install ${build_dir} --prefix ${work_dir}/first)
execute_process(COMMAND ${install} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND find ${work_dir}/first -mindepth 1 ( -type d ! -perm -755 -o -type f ! -perm -444 )
                OUTPUT_VARIABLE closed COMMAND_ERROR_IS_FATAL ANY)
if(closed)
    message(SEND_ERROR "closed to other users:\n${closed}")
endif()

# All of it is uninstalled, and nothing else.
file(WRITE ${work_dir}/first/${data_dir}/ljmd/inputs/mine.toml "")
execute_process(COMMAND ${CMAKE_COMMAND} -D manifest=${build_dir}/install_manifest.txt
                        -P ${source_dir}/cmake/LjmdUninstall.cmake COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE left RELATIVE ${work_dir}/first ${work_dir}/first/*)
if(NOT left STREQUAL "${data_dir}/ljmd/inputs/mine.toml" OR EXISTS ${work_dir}/first/${include_dir}/ljmd)
    message(SEND_ERROR "left after uninstalling: ${left}")
endif()
file(REMOVE_RECURSE ${work_dir}/first)
execute_process(COMMAND ${install} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${work_dir}/first ${work_dir}/installed)
file(COPY ${source_dir}/tests/consumer DESTINATION ${work_dir})
file(COPY ${source_dir}/docs/examples DESTINATION ${work_dir}/consumer)

list(TRANSFORM libraries PREPEND ${lib_dir}/)
foreach(path ${bin_dir}/ljmd ${libraries} ${lib_dir}/pkgconfig/ljmd.pc ${lib_dir}/cmake/ljmd/ljmdConfig.cmake
             ${include_dir}/ljmd/ljmd.hpp ${data_dir}/ljmd/inputs ${data_dir}/ljmd/analysis ${data_dir}/ljmd/python/ljmd/reading/tables.py
             ${data_dir}/man/man1/ljmd.1 ${data_dir}/bash-completion/completions/ljmd ${data_dir}/zsh/site-functions/_ljmd
             ${data_dir}/fish/vendor_completions.d/ljmd.fish ${data_dir}/doc/ljmd/README.md
             ${data_dir}/doc/ljmd/docs/files.md)
    if(NOT EXISTS ${work_dir}/installed/${path})
        message(SEND_ERROR "not installed: ${path}")
    endif()
endforeach()

# The program finds its modules where they are now.
execute_process(COMMAND ${work_dir}/installed/${bin_dir}/ljmd info OUTPUT_VARIABLE info COMMAND_ERROR_IS_FATAL ANY)
foreach(module ${modules})
    string(FIND "${info}" " ${work_dir}/installed/${lib_dir}/ljmd/${module}.so\n" place)
    if(place EQUAL -1)
        message(SEND_ERROR "the installed program does not find ${module}:\n${info}")
    endif()
endforeach()

# Each installed header compiles alone: none includes one that is not installed, or needs another before it.
file(GLOB_RECURSE headers RELATIVE ${work_dir}/installed/${include_dir} ${work_dir}/installed/${include_dir}/*.hpp)
foreach(header ${headers})
    string(MAKE_C_IDENTIFIER ${header} name)
    file(WRITE ${work_dir}/consumer/headers/${name}.cpp "#include \"${header}\"\n")
endforeach()

# A path into the source or build tree would break on the next machine. So would one by which programs and libraries look
# for others, unless it is relative to their own place.
file(GLOB_RECURSE binaries ${work_dir}/installed/${bin_dir}/ljmd ${work_dir}/installed/*.so ${work_dir}/installed/*.so.*)
foreach(binary ${binaries})
    execute_process(COMMAND ${readelf} -d ${binary} OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
    if(dynamic MATCHES "\\(R(UN)?PATH\\)[^[]*\\[([^]]*)\\]" AND NOT CMAKE_MATCH_2 MATCHES "^\\$ORIGIN(/[^:]*)?$")
        message(SEND_ERROR "${binary} looks for libraries in ${CMAKE_MATCH_2}")
    endif()
endforeach()
file(GLOB_RECURSE texts ${work_dir}/installed/*.cmake ${work_dir}/installed/*.pc)
foreach(text ${texts})
    file(READ ${text} content)
    foreach(folder ${source_dir} ${build_dir} ${work_dir}/first)
        string(FIND "${content}" "${folder}" place)
        if(NOT place EQUAL -1)
            message(SEND_ERROR "${text} names ${folder}")
        endif()
    endforeach()
endforeach()
