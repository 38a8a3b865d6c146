#include "run/output_guard.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <utility>

#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Upper bound of the length of our file names, including names of growing files (ReplacementFile).
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

/// Whether there is a file or a link of this name. A link may lead to a file or nowhere.
/// @throws OutputRefused  something else has it
bool is_file_or_link(const fs::path& path, const std::string& consequence,
                     const std::pair<const char*, const char*>& instead) {
    if (!path.has_filename() || (files::exists(path) && !files::is_regular_file(path))) {
        throw OutputRefused(
            fmt::format("{} is in the way: a file of that name is to be written, and this is no file. {}.",
                        path.string(), consequence),
            {instead});
    }
    return files::is_taken(path);
}

/// Whether a file bears the mark of its kind. A link bears none: what it leads to may be somebody else's.
bool bears(const fs::path& path, std::string_view mark) {
    std::ifstream file;
    if (mark.empty() || files::type_of(path) != fs::file_type::regular || !open_input(path, file).empty()) {
        return false;
    }
    std::array<char, 4096> beginning{};
    file.read(beginning.data(), beginning.size());
    return std::string_view(beginning.data(), static_cast<std::size_t>(file.gcount())).find(mark) !=
           std::string_view::npos;
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
        if (is_file_or_link(path, consequence, another_directory)) {
            found.push_back(path);
        }
    }
    return found;
}

void require_writable(const fs::path& file, const Replacing& allowed) {
    if (!is_file_or_link(file, allowed.consequence, allowed.instead) || allowed.force || bears(file, allowed.mark)) {
        return;
    }
    const bool is_link = files::type_of(file) == fs::file_type::symlink;
    throw OutputRefused(fmt::format("{} is there already{}. {}.", file.string(),
                                    is_link                ? ", a link, which is not followed"
                                    : allowed.mark.empty() ? ""
                                                           : ", and was not written by ljmd",
                                    allowed.consequence),
                        {allowed.instead, {"or replace it", " with --force"}});
}

namespace {

Replacing checked(const fs::path& file, Replacing allowed) {
    require_writable(file, allowed);
    return allowed;
}

}  // namespace

NamedOutput::NamedOutput(const fs::path& file, Replacing allowed)
    : allowed_(checked(file, std::move(allowed))), growing_(file) {}

void NamedOutput::take_place() {
    require_writable(growing_.place().path(), allowed_);
    growing_.take_place();
}

void write_output(const fs::path& file, const Replacing& allowed, const std::function<void(OutputFile&)>& fill) {
    NamedOutput output(file, allowed);
    OutputFile growing(output.growing());
    fill(growing);
    growing.close_on_disk();
    output.take_place();
}

void write_output(const fs::path& file, const Replacing& allowed, std::string_view text) {
    write_output(file, allowed, [text](OutputFile& output) { output.write(text); });
}

void require_no_outputs(const fs::path& directory, const std::vector<std::string>& names, bool force,
                        const std::string& consequence) {
    require_usable(directory, consequence);
    for (const std::string& name : names) {
        require_writable(directory / name, {.force = force, .consequence = consequence, .instead = another_directory});
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
