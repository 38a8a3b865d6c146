#include "ljmd/io/scratch_directory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "ljmd/core/errors.hpp"

namespace ljmd {

ScratchDirectory::ScratchDirectory() {
    std::error_code error;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
    if (error) {
        throw FileError(fmt::format("no directory for temporary files: {}; does TMPDIR name one?", error.message()));
    }
    std::string pattern = (parent / "ljmd-").string() + std::string(6, 'X');  // mkdtemp replaces six X
    if (mkdtemp(pattern.data()) == nullptr) {
        throw FileError(fmt::format("cannot create {}: {}", pattern, std::strerror(errno)));
    }
    path_ = pattern;
}

ScratchDirectory::~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace ljmd
