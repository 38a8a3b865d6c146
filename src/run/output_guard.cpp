#include "ljmd/run/output_guard.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/file_system.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Upper bound of the length of our file names, including those of growing files (ReplacementFile).
constexpr std::size_t longest_name = 64;

std::string with_choices(const std::string& why, const OutputRefused::Choices& choices, bool for_commands) {
    std::string text;
    for (const auto& [what, how] : choices) {
        text += (text.empty() ? "" : ", ") + what + (for_commands ? how : "");
    }
    return fmt::format("{}\n  {}", why, text);
}

void require_usable(const fs::path& directory, const std::string& consequence) {
    if (files::is_too_long(directory / std::string(longest_name, 'x'))) {
        throw OutputRefused(
            fmt::format("the path {} is too long: files in it cannot be named. {}.", directory.string(), consequence),
            {{"choose a shorter one", " with --out"}});
    }
    if (files::is_no_directory(directory)) {
        throw InputError(fmt::format("{} exists and is not a directory. {}.", directory.string(), consequence));
    }
}

}  // namespace

OutputRefused::OutputRefused(const std::string& why, const Choices& choices)
    : InputError(with_choices(why, choices, false)), for_commands_(with_choices(why, choices, true)) {}

std::string output_name(std::string name, const std::string& ending) {
    constexpr std::size_t longest = 255;  // bytes, of Linux's file systems
    if (name.size() + ending.size() > longest) {
        std::size_t end = longest - ending.size();
        while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) {  // within a character of UTF-8
            --end;
        }
        name.resize(end);
    }
    return name + ending;
}

std::vector<fs::path> existing_outputs(const fs::path& directory, const std::vector<std::string>& names,
                                       const std::string& consequence) {
    require_usable(directory, consequence);
    std::vector<fs::path> found;
    for (const std::string& name : names) {
        const fs::path path = directory / name;
        const fs::file_type type = files::type_of(path);
        if (type == fs::file_type::regular || type == fs::file_type::symlink) {
            found.push_back(path);
        } else if (type != fs::file_type::not_found) {
            throw OutputRefused(
                fmt::format("{} is in the way: a file of that name is to be written, and this is no file. {}.",
                            path.string(), consequence),
                {another_directory});
        }
    }
    return found;
}

void require_no_outputs(const fs::path& directory, const std::vector<std::string>& names, bool force,
                        const std::string& consequence) {
    const std::vector<fs::path> found = existing_outputs(directory, names, consequence);
    if (!force && !found.empty()) {
        throw OutputRefused(fmt::format("{} is there already. {}.", found.front().string(), consequence),
                            {another_directory, {"or replace it", " with --force"}});
    }
}

void require_no_run(const fs::path& directory, const std::string& consequence) {
    if (files::is_taken(directory / "run.json")) {
        throw OutputRefused(fmt::format("{} is the directory of a run, whose files stay as they are. {}.",
                                        directory.string(), consequence),
                            {another_directory});
    }
}

}  // namespace ljmd
