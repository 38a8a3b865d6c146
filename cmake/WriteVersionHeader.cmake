# Writes the version header. Run as a script:
#
#     cmake -D source_dir=... -D template=... -D output=... -D version=... -D compiler=... -P WriteVersionHeader.cmake
#
# commit: the full hash of HEAD, with "-dirty" behind it when a tracked file differs from it; "unknown" where
# source_dir is not the top of a git work tree (an unpacked archive, even one inside another project's repository).
set(commit unknown)
find_program(git_program git)
if(git_program)
    execute_process(COMMAND ${git_program} -C ${source_dir} rev-parse --show-toplevel HEAD
                    RESULT_VARIABLE failed OUTPUT_VARIABLE answer ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REGEX MATCH "^(.*)\n([0-9a-f]+)$" answer "${answer}")
    set(head "${CMAKE_MATCH_2}")
    file(REAL_PATH "${CMAKE_MATCH_1}" top)
    file(REAL_PATH "${source_dir}" here)
    if(NOT failed AND answer AND top STREQUAL here)
        set(commit ${head})
        # --no-optional-locks: a build must not get in the way of a git command that runs at the same time.
        execute_process(COMMAND ${git_program} --no-optional-locks -C ${source_dir} status --porcelain
                                --untracked-files=no
                        OUTPUT_VARIABLE changes ERROR_QUIET)
        if(changes)
            string(APPEND commit -dirty)
        endif()
    endif()
endif()

string(REGEX REPLACE "([\\\"])" "\\\\\\1" flags "${flags}")
configure_file(${template} ${output} @ONLY)
