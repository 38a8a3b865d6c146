# What cmake/WriteVersionHeader.cmake promises, on a repository made for it: outside git "unknown", else the commit,
# "-dirty" once a tracked file was changed, and a file that is left alone when nothing changed.
file(REMOVE_RECURSE ${work_dir})
file(MAKE_DIRECTORY ${work_dir}/repository/inner)
set(header ${work_dir}/version.hpp)
find_program(git_program git REQUIRED)

function(git)
    execute_process(COMMAND ${git_program} -C ${work_dir}/repository -c user.name=test -c user.email=test@example.org
                            -c commit.gpgsign=false ${ARGN}
                    OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(answer "${answer}" PARENT_SCOPE)
endfunction()

function(expect_commit expected folder)
    execute_process(COMMAND ${CMAKE_COMMAND} -D source_dir=${folder} -D output=${header} -D version=1.2.3
                            -D template=${source_dir}/cmake/version.hpp.in -D "flags=-DQUOTED=\"yes\""
                            -P ${source_dir}/cmake/WriteVersionHeader.cmake
                    COMMAND_ERROR_IS_FATAL ANY)
    file(STRINGS ${header} line REGEX LJMD_COMMIT)
    if(NOT line STREQUAL "#define LJMD_COMMIT \"${expected}\"")
        message(SEND_ERROR "expected commit ${expected}, the header says: ${line}")
    endif()
endfunction()

git(init --quiet)
expect_commit(unknown ${work_dir}/repository)  # no commit yet
file(WRITE ${work_dir}/repository/inner/file "one")
git(add inner/file)
git(commit --quiet -m first)
git(rev-parse HEAD)
set(first ${answer})

expect_commit(${first} ${work_dir}/repository)
file(WRITE ${work_dir}/repository/untracked "")
file(TIMESTAMP ${header} before "%s%f")
expect_commit(${first} ${work_dir}/repository)
file(TIMESTAMP ${header} after "%s%f")
if(NOT before STREQUAL after)
    message(SEND_ERROR "the header was written again although nothing changed")
endif()

file(WRITE ${work_dir}/repository/inner/file "two")
expect_commit(${first}-dirty ${work_dir}/repository)
git(commit --quiet --all -m second)
git(rev-parse HEAD)
expect_commit(${answer} ${work_dir}/repository)
expect_commit(unknown ${work_dir}/repository/inner)  # a folder of somebody else's repository

file(STRINGS ${header} line REGEX LJMD_FLAGS)
if(NOT line STREQUAL [[#define LJMD_FLAGS "-DQUOTED=\"yes\""]])
    message(SEND_ERROR "quotes in flags are not escaped: ${line}")
endif()
