#include "io/formats/body_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/text_file.hpp"
#include "io/hdf5/hdf5_input.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};
constexpr std::size_t every_axis = axes.size();

/// Vectors of all bodies, three numbers each. `velocities` is empty where a file has none.
struct BodyFrame {
    double step;
    double time;
    std::vector<double> positions;
    std::vector<double> velocities;
};

/// The number of axes up to the last one that is used in any frame; at least 1.
std::size_t used_axes(const std::vector<BodyFrame>& frames) {
    std::size_t used = 1;
    for (const BodyFrame& frame : frames) {
        for (const std::vector<double>& vectors : {frame.positions, frame.velocities}) {
            for (std::size_t k = 0; k < vectors.size(); ++k) {
                used = vectors[k] != 0.0 ? std::max(used, k % every_axis + 1) : used;
            }
        }
    }
    return used;
}

DataTable table_of(const std::vector<BodyFrame>& frames) {
    DataTable table{"trajectory", {"step", "time"}, {}};
    if (frames.empty()) {
        return table;
    }
    const std::size_t used = used_axes(frames);
    const std::size_t bodies = frames.front().positions.size() / every_axis;
    const bool moving = !frames.front().velocities.empty();
    for (std::size_t body = 1; body <= bodies; ++body) {
        for (const char* of : moving ? std::vector<const char*>{"", "v"} : std::vector<const char*>{""}) {
            for (std::size_t axis = 0; axis < used; ++axis) {
                table.columns.push_back(fmt::format("{}{}{}", of, axes.at(axis), body));
            }
        }
    }
    for (const BodyFrame& frame : frames) {
        std::vector<double> row{frame.step, frame.time};
        row.reserve(table.columns.size());
        const auto add = [&](const std::vector<double>& vectors, std::size_t body) {
            const auto begin = vectors.begin() + static_cast<std::ptrdiff_t>(every_axis * body);
            row.insert(row.end(), begin, begin + static_cast<std::ptrdiff_t>(used));
        };
        for (std::size_t body = 0; body < bodies; ++body) {
            add(frame.positions, body);
            if (moving) {
                add(frame.velocities, body);
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// The value of a key of the comment line, up to the next blank; empty if there is none.
std::string_view value_of(std::string_view line, std::string_view key) {
    const std::size_t at = line.find(key);
    if (at == std::string_view::npos) {
        return {};
    }
    const std::string_view rest = line.substr(at + key.size());
    return rest.substr(0, rest.find(' '));
}

/// The column in which a property of "species:S:1:pos:R:3" starts.
std::optional<std::size_t> column_of(const TextFile& file, std::string_view properties, std::string_view wanted) {
    std::size_t column = 0;
    while (!properties.empty()) {
        const auto take = [&] {
            const std::string_view word = properties.substr(0, properties.find(':'));
            properties.remove_prefix(std::min(word.size() + 1, properties.size()));
            return word;
        };
        const std::string_view name = take();
        take();
        if (name == wanted) {
            return column;
        }
        column += static_cast<std::size_t>(std::max<Index>(1, file.integer(take(), "the columns of a property")));
    }
    return std::nullopt;
}

void add_vector(const TextFile& file, const std::vector<std::string_view>& fields, std::size_t column,
                std::vector<double>& vectors) {
    if (fields.size() < column + every_axis) {
        file.fail(fmt::format("{} columns, but Properties has more", fields.size()));
    }
    for (std::size_t axis = 0; axis < every_axis; ++axis) {
        vectors.push_back(file.number(fields[column + axis], axes.at(axis)));
    }
}

/// The next frame; nothing at the end of the file, within its last frame, too.
std::optional<BodyFrame> next_frame(TextFile& file, Index& bodies) {
    std::vector<std::string_view> fields;
    const auto next_whole_line = [&file] { return file.next_line() && !file.is_cut(); };
    if (!next_whole_line()) {
        return std::nullopt;
    }
    const Index count = file.integer(file.line(), "the number of bodies");
    if (count < 1 || (bodies > 0 && count != bodies)) {
        file.fail(fmt::format("{} bodies, but the first frame has {}", count, bodies));
    }
    bodies = count;
    if (!next_whole_line()) {
        return std::nullopt;
    }
    const std::string comment(file.line());
    const std::optional<std::size_t> position = column_of(file, value_of(comment, "Properties="), "pos");
    const std::optional<std::size_t> velocity = column_of(file, value_of(comment, "Properties="), "velo");
    if (!position) {
        file.fail("Properties has no pos:R:3");
    }
    BodyFrame frame{file.number(value_of(comment, "step="), "the step"),
                    file.number(value_of(comment, "Time="), "the time"),
                    {},
                    {}};
    for (Index body = 0; body < count; ++body) {
        if (!next_whole_line()) {
            return std::nullopt;
        }
        split_fields(file.line(), fields);
        add_vector(file, fields, *position, frame.positions);
        if (velocity) {
            add_vector(file, fields, *velocity, frame.velocities);
        }
    }
    return frame;
}

std::vector<BodyFrame> xyz_frames(const std::filesystem::path& path) {
    TextFile file(path);
    std::vector<BodyFrame> frames;
    Index bodies = 0;
    while (auto frame = next_frame(file, bodies)) {
        frames.push_back(std::move(*frame));
    }
    return frames;
}

std::vector<BodyFrame> h5md_frames(const std::filesystem::path& path) {
    const Hdf5Input file(path);
    const std::string group = "particles/trajectory/";
    const std::string position = group + "position/value";
    const std::string velocity = group + "velocity/value";
    const bool moving = file.exists(velocity);
    std::vector<std::string> arrays{group + "position/step", group + "position/time", position};
    if (moving) {
        arrays.push_back(velocity);
    }
    std::optional<Index> whole;  // frames that are there in every array
    for (const std::string& array : arrays) {
        const std::vector<Index> extent = file.exists(array) ? file.extent(array) : std::vector<Index>{};
        if (extent.empty()) {
            file.fail(fmt::format("there are no frames in {}", array));
        }
        whole = std::min(whole.value_or(extent[0]), extent[0]);
    }
    const std::vector<Index> extent = file.extent(position);
    if (extent.size() != 3 || extent[2] != 3 || (moving && file.extent(velocity).size() != 3)) {
        file.fail(fmt::format("{} does not hold vectors of three numbers", position));
    }
    const std::vector<double> steps = file.first_numbers(arrays[0], *whole);
    const std::vector<double> times = file.first_numbers(arrays[1], *whole);
    std::vector<BodyFrame> frames;
    for (Index k = 0; k < *whole; ++k) {
        const auto place = static_cast<std::size_t>(k);
        frames.push_back({steps.at(place), times.at(place), file.numbers_at(position, k),
                          moving ? file.numbers_at(velocity, k) : std::vector<double>{}});
        if (moving && frames.back().velocities.size() != frames.back().positions.size()) {
            file.fail(fmt::format("{} and {} are of different bodies", position, velocity));
        }
    }
    return frames;
}

}  // namespace

DataTable read_body_trajectory(const std::filesystem::path& path) {
    return table_of(is_hdf5(path) ? h5md_frames(path) : xyz_frames(path));
}

}  // namespace ljmd
