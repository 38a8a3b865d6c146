#include "io/files/replacement_file.hpp"
#include "io/files/file_system.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <random>
#include <system_error>
#include <utility>
#include <vector>

#include "io/files/file_calls.hpp"

namespace ljmd {

namespace {

constexpr std::string_view prefix = ".ljmd-";
constexpr std::string_view prefix_alone = ".ljmd-locked-";
constexpr std::size_t digits = 16;

std::string random_name(bool alone) {
    std::random_device random;
    const std::uint64_t number = (std::uint64_t{random()} << 32U) | random();
    return fmt::format("{}{:0{}x}", alone ? prefix_alone : prefix, number, digits);
}

bool is_left_over(std::string_view name) {
    return name.size() == prefix_alone.size() + digits && name.starts_with(prefix_alone) &&
           name.find_first_not_of("0123456789abcdef", prefix_alone.size()) == std::string_view::npos;
}

/// Files and links to files may be replaced; directories, pipes and devices may not. @throws FileError
void require_replaceable(const OutputPlace& place) {
    const auto status = status_of(place);
    if (status && !S_ISREG(status->st_mode) && !S_ISLNK(status->st_mode)) {
        throw FileError(fmt::format("cannot write '{}': what is there is not a regular file", place.path().string()));
    }
}

OutputPlace made_beside(const OutputPlace& place) {
    require_replaceable(place);
    constexpr mode_t permissions = 0666;  // reduced by the umask
    while (true) {
        OutputPlace beside(place.directory, random_name(place.directory.is_held_alone()));
        const int descriptor = ::openat(place.directory.descriptor(), beside.name.c_str(),
                                        O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
        if (descriptor >= 0) {
            ::close(descriptor);
            return beside;
        }
        if (errno != EEXIST && errno != EINTR) {
            throw file_error("write", place.path(), errno);
        }
    }
}

}  // namespace

ReplacementFile::ReplacementFile(OutputPlace place) : place_(std::move(place)), growing_(made_beside(place_)) {}

ReplacementFile::~ReplacementFile() {
    if (!taken_) {
        ::unlinkat(growing_.directory.descriptor(), growing_.name.c_str(), 0);
    }
}

void ReplacementFile::take_place() {
    const int directory = place_.directory.descriptor();
    if (::renameat(directory, growing_.name.c_str(), directory, place_.name.c_str()) != 0) {
        throw file_error("replace", place_.path(), errno);
    }
    taken_ = true;
    place_.directory.sync();
}

void remove_left_over(const OpenDirectory& directory) {
    std::vector<std::filesystem::path> there;
    try {
        there = files::list(directory.path());
    } catch (const FileError&) {  // the directory may be writable but not readable
        return;
    }
    // Remove by descriptor: if the path leads elsewhere by now, there are no files of these names.
    for (const std::filesystem::path& path : there) {
        if (const std::string name = path.filename().string(); is_left_over(name)) {
            ::unlinkat(directory.descriptor(), name.c_str(), 0);
        }
    }
}

void write_file_atomically(const OutputPlace& place, const std::function<void(OutputFile&)>& fill) {
    ReplacementFile replacement(place);
    OutputFile file(replacement);
    fill(file);
    file.sync();
    file.close();
    replacement.take_place();
}

void write_file_atomically(const OutputPlace& place, std::string_view text) {
    write_file_atomically(place, [text](OutputFile& file) { file.write(text); });
}

}  // namespace ljmd
