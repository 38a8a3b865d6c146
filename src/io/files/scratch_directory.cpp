#include "ljmd/io/files/scratch_directory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/file_system.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Waits for the end of its stdin. Signals that end this program and all of its group are not for it; and a program
/// that writes into the directory may end a moment later than this one, so it tries more than once.
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
    } catch (const Error&) {  // the program waits for all its children elsewhere
    }
}

}  // namespace ljmd
