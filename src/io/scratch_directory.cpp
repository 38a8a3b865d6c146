#include "ljmd/io/scratch_directory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/file_system.hpp"

namespace ljmd {

ScratchDirectory::ScratchDirectory() {
    std::string pattern =
        (files::temporary_folder() / "ljmd-").string() + std::string(6, 'X');  // mkdtemp replaces six X
    if (mkdtemp(pattern.data()) == nullptr) {
        throw FileError(fmt::format("cannot create {}: {}", pattern, std::strerror(errno)));
    }
    path_ = pattern;
}

ScratchDirectory::~ScratchDirectory() {
    files::try_to_remove_all(path_);
}

}  // namespace ljmd
