#include "io/formats/readable_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/text.hpp"
#include "io/files/input_file.hpp"
#include "io/formats/configuration_check.hpp"
#include "io/formats/format_elsewhere.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

std::string beginning_of(const std::filesystem::path& path) {
    std::ifstream file = open_input(path);
    std::string bytes(512, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max(file.gcount(), std::streamsize{0})));
    return bytes;
}

}  // namespace

std::optional<ReadableFormat> format_of(const std::filesystem::path& path) {
    TextFile file(path);  // refuses files that are not regular, which HDF5 would open
    if (const std::string words = format_elsewhere(path, beginning_of(path)); !words.empty()) {
        throw DataError(fmt::format("{}: {}", path.string(), words));
    }
    for (const ReadableFormat& format : all_readable_formats()) {
        if (format.recognises(path, file)) {
            return format;
        }
        file.rewind();
    }
    if (!file.next_line()) {
        file.fail_at(0, "the file is empty");
    }
    return std::nullopt;
}

Configuration last_frame(TrajectoryReader& reader, const std::filesystem::path& path) {
    Frame frame;
    Configuration last;
    while (reader.next(frame)) {
        last = std::move(frame.configuration);
    }
    for (const std::string& warning : reader.warnings()) {
        if (std::ranges::find(last.remarks, warning) == last.remarks.end()) {
            throw DataError(warning);
        }
    }
    if (const auto same = find_coincident_atoms(last)) {
        throw DataError(fmt::format("{}: atoms {} and {} are at the same place in the periodic box", path.string(),
                                    same->first + 1, same->second + 1));
    }
    return last;
}

std::string readable_formats(bool trajectories) {
    std::string text;
    std::vector<std::string> names;
    for (const ReadableFormat& format : all_readable_formats()) {
        if (!trajectories || format.trajectory) {
            names.push_back(format.name);
        }
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == names.size() ? " or " : ", ") + names[k];
    }
    return text;
}

}  // namespace ljmd
