#include "io/formats/trajectory_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/files/text_file.hpp"
#include "io/formats/readable_format.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr double same_place = 1e-4;  // in units of an edge: allows for digits that text files lack

/// The place of a frame in the order of the file: its step, or its time.
std::optional<double> place_of(const Frame& frame) {
    const Configuration& found = frame.configuration;
    return found.step ? std::optional(static_cast<double>(*found.step)) : found.time;
}

bool are_same(const std::vector<Vec3>& one, const std::vector<Vec3>& other, const Vec3& edges) {
    return std::ranges::equal(one, other, [&](const Vec3& a, const Vec3& b) {
        return ((a - b).array().abs() <= same_place * edges.array()).all();
    });
}

}  // namespace

bool TrajectoryReader::read_whole(Frame& frame) {
    try {
        return read(frame);
    } catch (const DataError& error) {
        if (frames_ == 0 || !is_cut()) {
            throw;
        }
        warn(fmt::format("{}; the {} {} before it {} used", error.what(), frames_, frames_ == 1 ? "frame" : "frames",
                         frames_ == 1 ? "is" : "are"));
        return false;
    }
}

void TrajectoryReader::check_like_first(const Frame& frame) {
    const auto atoms = static_cast<Index>(frame.configuration.positions.size());
    const bool has_step = frame.configuration.step.has_value();
    const bool has_time = frame.configuration.time.has_value();
    if (frames_ == 0) {
        atoms_ = atoms;
        has_step_ = has_step;
        has_time_ = has_time;
        ids_ = frame.ids;
    } else if (atoms != atoms_) {
        fail(fmt::format("{} atoms, but frame 1 has {}", atoms, atoms_));
    } else if (has_step != has_step_) {
        fail(has_step ? "a step, which frame 1 has not" : "no step, which frame 1 has");
    } else if (has_time != has_time_) {
        fail(has_time ? "a time, which frame 1 has not" : "no time, which frame 1 has");
    } else if (frame.ids.size() != ids_.size()) {
        fail(ids_.empty() ? "ids, which frame 1 has not" : "no ids, which frame 1 has");
    } else if (frame.ids != ids_) {
        const auto [here, first] = std::ranges::mismatch(frame.ids, ids_);
        fail(fmt::format("other atoms than in frame 1: id {}, where that has id {}", *here, *first));
    }
}

void TrajectoryReader::fail_by(const ConfigurationFault& fault, Index id) const {
    std::string message;
    try {
        fail(fault.atom ? fmt::format("atom {} {}", id, fault.message) : fault.message);
    } catch (const DataError& error) {
        message = error.what();
    }
    if (fault.is_lost) {
        throw NotFinite(message);
    }
    throw DataError(message);
}

/// Whether the frame comes after all counted ones.
bool TrajectoryReader::is_counted(Frame& frame) {
    const std::optional<double> place = place_of(frame);
    const Configuration& found = frame.configuration;
    if (place && *place <= last_place_) {
        first_repeated_ = repeated_ == 0 ? frames_ : first_repeated_;
        ++repeated_;
        is_joined_ = *place == last_place_ && are_same(found.positions, last_positions_, found.edges);
        return false;
    }
    frame.begins_anew = !is_joined_;
    begins_anew_ = begins_anew_ || frame.begins_anew;
    is_joined_ = true;
    last_place_ = place.value_or(last_place_);
    last_positions_ = found.positions;
    return true;
}

bool TrajectoryReader::next(Frame& frame) {
    while (read_whole(frame)) {
        check_like_first(frame);
        ++frames_;
        for (const std::string& remark : frame.configuration.remarks) {
            warn(remark);
        }
        if (is_counted(frame)) {
            return true;
        }
    }
    return false;
}

void TrajectoryReader::warn(const std::string& text) {
    if (std::ranges::find(warnings_, text) == warnings_.end()) {
        warnings_.push_back(text);
    }
}

std::vector<std::string> TrajectoryReader::warnings() const {
    std::vector<std::string> all = warnings_;
    if (repeated_ > 0) {
        const bool one = repeated_ == 1;
        all.push_back(fmt::format(
            "{} (or {}) of frames before {}: each is counted once, as it came first{}",
            one ? fmt::format("1 frame, frame {}, repeats a step", first_repeated_)
                : fmt::format("{} frames, the first of them frame {}, repeat steps", repeated_, first_repeated_),
            one ? "a time" : "times", one ? "it" : "them",
            begins_anew_ ? "; what follows does not go on from there, so nothing is compared in time across the gap"
                         : ""));
    }
    return all;
}

std::unique_ptr<TrajectoryReader> open_trajectory(const std::filesystem::path& path,
                                                  const std::optional<SubstanceUnits>& units, const std::string& group,
                                                  const std::string& xyz_comment) {
    const std::optional<ReadableFormat> format = format_of(path);
    const auto fail = [&](const std::string& why) { return DataError(fmt::format("{}: {}", path.string(), why)); };
    if (!xyz_comment.empty() && !(format && format->takes_comment)) {
        throw fail("is no extended XYZ file, but --xyz-comment is given");
    }
    if (!group.empty() && !(format && format->has_groups)) {
        throw fail(fmt::format("only an H5MD file has groups of particles, such as {}", shown(group)));
    }
    if (!format || !format->trajectory) {
        throw fail(fmt::format("unknown format; {} can be read", readable_formats(true)));
    }
    return format->trajectory(path, {units, group, xyz_comment});
}

}  // namespace ljmd
