#include "io/files/scratch_directory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "io/files/file_system.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Waits for the end of its stdin. It ignores the signals that end this program with its process group. A program that
/// writes into the directory may end later than this one, so removal is tried several times.
constexpr const char* remove_at_end_of_input = R"(trap '' HUP INT QUIT TERM USR1 USR2
read -r end
for attempt in 1 2 3 4 5; do
    rm -rf -- "$1" && exit
    sleep 1
done)";

fs::path new_directory() {
    std::string pattern =
        (files::temporary_folder() / "ljmd-").string() + std::string(6, 'X');  // mkdtemp replaces six X
    if (mkdtemp(pattern.data()) == nullptr) {
        throw FileError(fmt::format("cannot create {}: {}", pattern, std::strerror(errno)));
    }
    return pattern;
}

}  // namespace

ScratchDirectory::ScratchDirectory() : path_(new_directory()) {
    try {
        remover_.emplace(Process{.program = "/bin/sh",
                                 .arguments = {"-c", remove_at_end_of_input, "ljmd-scratch", path_.string()},
                                 .directory = ".",
                                 .output = "/dev/null",
                                 .own_group = true,
                                 .at_our_end = 0,
                                 .input = life_.read_end()});
    } catch (...) {
        files::try_to_remove_all(path_);
        throw;
    }
    life_.close_read_end();
}

ScratchDirectory::~ScratchDirectory() {
    files::try_to_remove_all(path_);
    life_.close_write_end();
    try {
        static_cast<void>(remover_->wait());
    } catch (const Error&) {  // the program may already have waited for all its children
    }
}

}  // namespace ljmd
