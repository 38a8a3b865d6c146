#include "ljmd/io/input_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace fs = std::filesystem;

std::string why_unreadable(const fs::path& path) {
    std::error_code code;
    switch (fs::status(path, code).type()) {
        case fs::file_type::regular:
            return {};
        case fs::file_type::not_found:
            return "no such file";
        case fs::file_type::directory:
            return "is a directory, not a regular file";
        case fs::file_type::fifo:
            return "is a pipe, not a regular file";
        case fs::file_type::none:
            return "cannot be read: " + code.message();
        default:
            return "is a device or a socket, not a regular file";
    }
}

std::ifstream open_input(const fs::path& path) {
    std::string complaint = why_unreadable(path);
    std::ifstream file;
    if (complaint.empty()) {
        errno = 0;
        file.open(path, std::ios::binary);
        if (!file) {
            complaint = "cannot be read: " + std::generic_category().message(errno);
        }
    }
    if (!complaint.empty()) {
        throw DataError(fmt::format("{}: {}", path.string(), complaint));
    }
    return file;
}

}  // namespace ljmd
