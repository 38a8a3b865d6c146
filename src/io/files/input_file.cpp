#include "ljmd/io/files/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/file_system.hpp"

namespace ljmd {

namespace fs = std::filesystem;

namespace {

constexpr const char* utf_16 = "is a text in UTF-16; UTF-8 is read: iconv -f UTF-16 -t UTF-8 OLD > NEW";

/// Files that the kernel makes up have no size, and some of them, as /proc/kmsg, are waited for.
bool is_of_kernel(const fs::path& path) {
    std::error_code code;
    const std::string place = fs::canonical(path, code).string();
    return (place.starts_with("/proc/") || place.starts_with("/sys/")) && fs::file_size(path, code) == 0;
}

}  // namespace

std::string why_unreadable(const fs::path& path) {
    std::error_code code;
    switch (fs::status(path, code).type()) {
        case fs::file_type::regular:
            return is_of_kernel(path) ? "is made up by the kernel, not a file that is stored; copy it first" : "";
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

bool input_is_there(const fs::path& path) {
    try {
        return files::is_taken(path);
    } catch (const FileError& error) {
        throw DataError(error.what());
    }
}

std::string open_input(const fs::path& path, std::ifstream& file) {
    std::string complaint = why_unreadable(path);
    if (complaint.empty()) {
        errno = 0;
        file.open(path, std::ios::binary);
        if (!file) {
            complaint = why_reading_failed();
        }
    }
    return complaint;
}

std::ifstream open_input(const fs::path& path) {
    std::ifstream file;
    if (const std::string complaint = open_input(path, file); !complaint.empty()) {
        throw DataError(fmt::format("{}: {}", path.string(), complaint));
    }
    return file;
}

std::string read_input(const fs::path& path) {
    std::ifstream file = open_input(path);
    std::string text;
    constexpr std::size_t piece = std::size_t{1} << 16;
    while (file) {
        const std::size_t before = text.size();
        text.resize(before + piece);
        file.read(text.data() + before, piece);
        text.resize(before + static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) {
        throw DataError(fmt::format("{}: {}", path.string(), why_reading_failed()));
    }
    return text;
}

std::string why_reading_failed() {
    return "cannot be read: " + std::generic_category().message(errno);
}

std::string why_no_text(std::string_view beginning) {
    using namespace std::string_view_literals;
    struct Kind {
        std::string_view first_bytes;
        const char* name;
    };
    constexpr std::array<Kind, 9> kinds{{{"\x89HDF\r\n\x1a\n"sv, "is an HDF5 file, not a text"},
                                         {"\x1f\x8b"sv, "is compressed with gzip; unpack it first"},
                                         {"\xFD"
                                          "7zXZ\0"sv,
                                          "is compressed with xz; unpack it first"},
                                         {"\x28\xB5\x2F\xFD"sv, "is compressed with zstd; unpack it first"},
                                         {"BZh"sv, "is compressed with bzip2; unpack it first"},
                                         {"PK\x03\x04"sv, "is a zip archive; unpack it first"},
                                         {"\xFF\xFE"sv, utf_16},
                                         {"\xFE\xFF"sv, utf_16},
                                         {"CDF\x01"sv, "is a NetCDF file, not a text"}}};
    const auto* const kind =
        std::ranges::find_if(kinds, [&](const Kind& each) { return beginning.starts_with(each.first_bytes); });
    if (kind != kinds.end()) {
        return kind->name;
    }
    if (beginning.size() >= 4 && (beginning[0] == '\0') != (beginning[1] == '\0') &&
        (beginning[0] == '\0') == (beginning[2] == '\0') && (beginning[1] == '\0') == (beginning[3] == '\0')) {
        return utf_16;  // without a mark: of each two bytes one is zero
    }
    if (beginning.find('\r') != std::string_view::npos && beginning.find('\n') == std::string_view::npos) {
        return "has lines that end in CR alone, as on old Macs; LF is read: tr '\\r' '\\n' < OLD > NEW";
    }
    return {};
}

}  // namespace ljmd
