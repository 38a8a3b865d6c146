#include "judge/answer_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>

#include "core/text.hpp"
#include "io/files/file_system.hpp"
#include "io/files/text_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "io/tables/json_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 6> frame_suffixes{".xyz", ".extxyz", ".dump", ".lammpsdump", ".lammpstrj", ".h5md"};
constexpr std::size_t longest_name = 80;

std::vector<fs::path> frames_files(const fs::path& directory, const std::string& name) {
    std::vector<fs::path> found;
    for (const char* suffix : frame_suffixes) {
        const fs::path path = directory / (name + suffix);
        if (files::exists(path)) {
            found.push_back(path);
        }
    }
    return found;
}

/// The file with frames of this name; nothing if there is none. @throws DataError  there are several
std::optional<fs::path> frames_file(const fs::path& directory, const std::string& name) {
    const std::vector<fs::path> found = frames_files(directory, name);
    if (found.size() > 1) {
        throw DataError(fmt::format("{} and {}: one file is enough, it is not known which one counts",
                                    found[0].string(), found[1].filename().string()));
    }
    return found.empty() ? std::nullopt : std::optional(found[0]);
}

std::optional<double> number(const Data& json, const char* key) {
    const Data* value = json.find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_number() || !std::isfinite(value->number())) {
        throw WrongData(fmt::format("'{}' is no finite number", key));
    }
    return value->number();
}

/// W, given as a number or as a tensor of 3 x 3.
std::optional<double> virial_of(const Data& json) {
    const Data* value = json.find("virial");
    if (value == nullptr || !value->is_list()) {
        return number(json, "virial");
    }
    double trace = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (value->size() != 3 || (*value)[k].size() != 3) {
            throw WrongData("'virial' is neither a number nor a tensor of 3 x 3 numbers");
        }
        trace += (*value)[k][k].number();
    }
    return trace;
}

std::vector<Vec3> forces_of(const Data& json, Index atoms) {
    const Data* value = json.find("forces");
    std::vector<Vec3> forces;
    if (value == nullptr) {
        return forces;
    }
    if (std::ssize(value->items()) != atoms) {
        throw WrongData(fmt::format("'forces' holds {} vectors, the problem has {} atoms", value->size(), atoms));
    }
    forces.reserve(value->size());
    for (const Data& item : value->items()) {
        if (item.items().size() != 3) {
            throw WrongData(fmt::format("force {} has {} components", forces.size() + 1, item.size()));
        }
        forces.emplace_back(item[0].number(), item[1].number(), item[2].number());
        if (!forces.back().allFinite()) {
            throw WrongData(fmt::format("force {} is not finite", forces.size()));
        }
    }
    return forces;
}

void read_point(const fs::path& path, Index atoms, bool judged, Answer& answer) {
    read_json(path, "a point", [&](const Data& json) {
        if (!json.is_object()) {
            throw WrongData("it holds no object {...}");
        }
        static const std::array<const char*, 8> known{"potential_energy", "kinetic_energy",    "temperature",
                                                      "virial",           "pressure",          "forces",
                                                      "engine",           "degrees_of_freedom"};
        for (const Member& member : json.members()) {
            if (std::ranges::find(known, member.key) == known.end()) {
                answer.warnings.push_back(fmt::format("{}: the key {} is not known; known are {}", path.string(),
                                                      in_quotes(member.key), fmt::join(known, ", ")));
            }
        }
        if (judged) {
            answer.point = {.potential_energy = number(json, "potential_energy"),
                            .kinetic_energy = number(json, "kinetic_energy"),
                            .temperature = number(json, "temperature"),
                            .virial = virial_of(json),
                            .pressure = number(json, "pressure"),
                            .forces = forces_of(json, atoms)};
        }
        if (const Data* engine = json.find("engine")) {
            answer.engine = printable(engine->text(), longest_name);
        }
        if (const Data* freedom = json.find("degrees_of_freedom")) {
            answer.degrees_of_freedom = integer_of(*freedom, "degrees_of_freedom", 1, 3 * atoms);
        }
        return 0;
    });
}

/// The box of a frame: its edges may have been through text of ten digits.
void check_box(const fs::path& path, Index number, const Vec3& edges, const Vec3& expected) {
    constexpr double same = 1e-9;
    if (!((edges - expected).array().abs() <= same * expected.array()).all()) {
        throw DataError(
            fmt::format("{}: frame {}: the edges of the box are {}, {}, {}; those of the problem {}, {}, {}",
                        path.string(), number, edges[0], edges[1], edges[2], expected[0], expected[1], expected[2]));
    }
}

void check_forces(const fs::path& path, Index number, const Frame& frame) {
    const auto bad = std::ranges::find_if(frame.forces, [](const Vec3& force) { return !force.allFinite(); });
    if (bad == frame.forces.end()) {
        return;
    }
    const auto k = static_cast<std::size_t>(bad - frame.forces.begin());
    throw NotFinite(fmt::format("{}: frame {}: atom {} has a force that is not finite", path.string(), number,
                                frame.ids.empty() ? static_cast<Index>(k) + 1 : frame.ids[k]));
}

/// The step of a frame, which may have only a time.
Index step_of(const fs::path& path, Index number, const Configuration& configuration, double time_step) {
    constexpr double off = 1e-3;  // of a step
    if (configuration.step) {
        return *configuration.step;
    }
    const double steps = configuration.time.value_or(0.0) / time_step;
    if (!configuration.time || std::abs(steps - std::round(steps)) > off) {
        throw DataError(fmt::format(
            "{}: frame {} has no step{}: which step of the trajectory it is, is not known", path.string(), number,
            configuration.time ? ", and its time is not a multiple of the time step" : " and no time"));
    }
    return static_cast<Index>(std::llround(steps));
}

/// A message without what it says before some words, or all of it.
std::string after(const std::string& message, const std::string& words) {
    const std::size_t place = message.find(words);
    return place == std::string::npos ? message : message.substr(place + words.size());
}

/// The next frame; false after the last one. What a message advises that no engine can do is left out.
bool next_frame(TrajectoryReader& reader, Frame& frame) {
    try {
        return reader.next(frame);
    } catch (const NotFinite&) {
        throw;
    } catch (const DataError& error) {
        const std::string message = error.what();
        throw DataError(message.substr(0, message.find(" It can be given beside the file")));
    }
}

/// The frames of a file that are wanted: an engine may write any number of them, which are read one by one. A file that
/// ends within a frame is refused: an engine that stops there has failed.
/// @param is_wanted  called with each frame and its number
/// @throws NotFinite  as reading does, with the number of the frame
template <class IsWanted>
std::vector<Frame> read_frames(const fs::path& path, const Problem& problem, std::vector<std::string>& warnings,
                               const IsWanted& is_wanted,
                               const std::function<void(Index, const std::string&)>& lost = nullptr) {
    const auto atoms = static_cast<Index>(problem.fluid.masses.size());
    const auto reader = open_trajectory(path, std::nullopt);
    std::vector<Frame> frames;
    const auto next_whole = [&](Frame& frame) {
        const Index number = reader->frames() + 1;
        try {
            const bool is_there = next_frame(*reader, frame);
            if (is_there) check_forces(path, reader->frames(), frame);
            return is_there;
        } catch (const NotFinite& error) {
            if (!lost || number == 1) {
                throw;
            }
            lost(number, after(error.what(), fmt::format("frame {}: ", number)));
            return false;
        }
    };
    for (Frame frame; next_whole(frame); frame = {}) {
        const Index number = reader->frames();
        if (std::ssize(frame.configuration.positions) != atoms) {
            throw DataError(fmt::format("{}: frame {} has {} atoms, the problem has {}", path.string(), number,
                                        frame.configuration.positions.size(), atoms));
        }
        check_box(path, number, frame.configuration.edges, problem.fluid.edges);
        if (is_wanted(frame, number)) {
            frames.push_back(std::move(frame));
        }
    }
    for (const std::string& warning : reader->warnings()) {
        if (warning.find("before it") != std::string::npos) {
            throw DataError(fmt::format("the file is cut off: {}", warning));
        }
        warnings.push_back(warning);
    }
    return frames;
}

std::vector<double> optional_column(const DataTable& table, const std::string& name, const fs::path& path) {
    return std::ranges::find(table.columns, name) == table.columns.end() ? std::vector<double>{}
                                                                         : full_column(table, name, path);
}

/// @throws DataError  the header has no column `step`
void check_columns(const fs::path& path) {
    const std::vector<std::string> columns = csv_columns(path);
    if (std::ranges::find(columns, "step") == columns.end()) {
        throw DataError(fmt::format("{}: no column 'step': the columns found are '{}'; separate them with commas",
                                    path.string(), printable(fmt::format("{}", fmt::join(columns, "', '")), 300)));
    }
}

ThermoAnswer read_thermo(const fs::path& path, std::vector<Loss>& losses) {
    constexpr std::uintmax_t most = std::uintmax_t{256} << 20U;  // bytes: millions of rows
    if (files::size_of(path).value_or(0) > most) {
        throw DataError(fmt::format("{} is larger than {} MiB: write fewer rows", path.string(), most >> 20U));
    }
    check_columns(path);
    std::string loss;
    const DataTable table = read_finite_csv(path, loss);
    if (!loss.empty()) {
        losses.push_back({"thermo.csv: all rows are finite",
                          fmt::format("the engine blew up: in line {}; the rows before it are judged",
                                      after(loss, path.filename().string() + ":"))});
    }
    if (table.rows.empty()) {
        throw DataError(fmt::format("{} has no row", path.string()));
    }
    return {.steps = step_column(table, path),
            .potential_energy = optional_column(table, "potential_energy", path),
            .kinetic_energy = optional_column(table, "kinetic_energy", path),
            .temperature = optional_column(table, "temperature", path),
            .pressure = optional_column(table, "pressure", path),
            .volume = optional_column(table, "volume", path)};
}

}  // namespace

bool has_answer(const fs::path& directory) {
    return files::exists(directory / "point.json") || files::exists(directory / "thermo.csv") ||
           !frames_files(directory, "point").empty() || !frames_files(directory, "frames").empty();
}

Answer read_answer(const fs::path& directory, const Problem& problem) {
    Answer answer;
    const auto atoms = static_cast<Index>(problem.fluid.masses.size());
    if (const fs::path path = directory / "point.json"; files::exists(path)) {
        read_point(path, atoms, problem.wants("point"), answer);
    }
    if (const auto path = problem.wants("point") ? frames_file(directory, "point") : std::nullopt) {
        Index count = 0;
        std::vector<Frame> frames = read_frames(*path, problem, answer.warnings, [&](const Frame&, Index number) {
            count = number;
            return number == 1;
        });
        if (count != 1 || frames[0].forces.empty()) {
            throw DataError(fmt::format("{} must hold one frame with forces, it has {}", path->string(),
                                        count == 1 ? "none" : fmt::format("{} frames", count)));
        }
        if (!answer.point.forces.empty()) {
            throw DataError(
                fmt::format("there are forces in {} and in point.json: one of them is enough", path->string()));
        }
        answer.point.forces = std::move(frames[0].forces);
    }
    if (const auto path = problem.wants("trajectory") ? frames_file(directory, "frames") : std::nullopt) {
        std::set<Index> seen;
        Index last = 0;
        answer.frames = read_frames(
            *path, problem, answer.warnings,
            [&](Frame& frame, Index number) {
                const Index step = step_of(*path, number, frame.configuration, problem.stage.time_step);
                frame.configuration.step = last = step;
                // The first one shows that there are frames, whatever their steps.
                return number == 1 || (std::ranges::binary_search(problem.frames, step) && seen.insert(step).second);
            },
            [&](Index number, const std::string& why) {
                // its step, where the frames before it are those that are asked for
                const auto place = static_cast<std::size_t>(number - 1);
                const bool is_known = place < problem.frames.size() && problem.frames[place - 1] == last;
                const std::string which = is_known ? fmt::format("frame {} (step {})", number, problem.frames[place])
                                                   : fmt::format("frame {}, after step {}", number, last);
                answer.losses.push_back(
                    {fmt::format("{}: {}: finite, and near the box", path->filename().string(), which),
                     fmt::format("the engine blew up: {}: {}; the frames before it are judged", which, why)});
            });
    }
    if (const fs::path path = directory / "thermo.csv"; problem.wants("averages") && files::exists(path)) {
        answer.thermo = read_thermo(path, answer.losses);
    }
    return answer;
}

}  // namespace ljmd
