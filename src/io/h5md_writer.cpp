#include "h5md_writer.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/input_file.hpp"
#include "ljmd/io/output_file.hpp"

namespace ljmd {

namespace {

const std::string particles = "particles/trajectory";

/// Chunks of the arrays with one small entry a frame: this many frames, a few kilobytes.
constexpr hsize_t frames_per_chunk = 64;

/// One frame a chunk; a frame above a mebibyte is divided into equal pieces below it.
Index atoms_per_chunk(Index atoms) {
    constexpr Index bytes_per_atom = 3 * sizeof(double);
    constexpr Index most_bytes = Index{1} << 20;
    const Index pieces = std::max<Index>(1, (atoms * bytes_per_atom + most_bytes - 1) / most_bytes);
    return std::max<Index>(1, (atoms + pieces - 1) / pieces);
}

std::vector<hsize_t> frame_chunk(Index atoms) {
    return {1, static_cast<hsize_t>(atoms_per_chunk(atoms)), 3};
}

/// Vectors in the order of ids, (N, 3) by rows.
template <class VectorOf>
std::vector<double> gathered(const State& state, double scale, VectorOf vector_of) {
    std::vector<double> result;
    result.reserve(3 * static_cast<std::size_t>(state.count()));
    for (const Index i : state.index_of()) {
        const Vec3 v = scale * vector_of(i);
        result.insert(result.end(), {v[0], v[1], v[2]});
    }
    return result;
}

/// Vectors of all atoms from the chunks at these places; what the file does not hold is left zero.
std::vector<double> vectors_at(std::ifstream& file, const std::vector<std::uint64_t>& places, Index atoms) {
    std::vector<double> vectors;
    const Index most = atoms_per_chunk(atoms);
    for (const std::uint64_t place : places) {
        const auto begin = vectors.size();
        const Index rest = atoms - static_cast<Index>(begin / 3);
        vectors.resize(begin + 3 * static_cast<std::size_t>(std::clamp<Index>(rest, 0, most)));
        file.clear();
        file.seekg(static_cast<std::streamoff>(place));
        file.read(reinterpret_cast<char*>(vectors.data() + begin),
                  static_cast<std::streamsize>((vectors.size() - begin) * sizeof(double)));
    }
    return vectors;
}

std::uint64_t checksum(const std::vector<double>& velocities, const std::vector<double>& positions) {
    const std::uint64_t first = XXH3_64bits(velocities.data(), velocities.size() * sizeof(double));
    return XXH3_64bits_withSeed(positions.data(), positions.size() * sizeof(double), first);
}

}  // namespace

H5mdWriter::H5mdWriter(const State& first, const TrajectoryOptions& options)
    : count_(first.count()),
      has_box_(first.has_box()),
      has_velocities_(options.velocities),
      scale_(unit_scale(options.si, 1.0)),
      temporary_(options.kept ? std::optional<TemporaryName>(options.path) : std::optional<TemporaryName>()),
      file_(temporary_ ? temporary_->name() : options.path),
      step_{particles + "/position/step", {}, H5T_NATIVE_INT64},
      time_{particles + "/position/time", {}, H5T_NATIVE_DOUBLE},
      edges_{particles + "/box/edges/value", {3, 3}, H5T_NATIVE_DOUBLE},
      velocity_{particles + "/velocity/value", {static_cast<hsize_t>(count_), 3}, H5T_NATIVE_DOUBLE},
      position_{particles + "/position/value", {static_cast<hsize_t>(count_), 3}, H5T_NATIVE_DOUBLE} {
    create_metadata(options);
    create_parameters(options);
    create_particles(first, options.si.has_value());
    create_box(options.si.has_value());
    file_.start_appending();
    if (options.kept) {
        copy_frames(options.path, options.kept->frames);
        file_.commit();
        temporary_->take_place();
        file_.renamed(options.path);
    }
}

void H5mdWriter::copy_frames(const std::filesystem::path& from, const std::vector<FramePlace>& frames) {
    require_bytes(from, 0);
    std::ifstream file = open_input(from);
    for (const FramePlace& frame : frames) {
        const Vectors vectors{vectors_at(file, frame.velocities, count_), vectors_at(file, frame.positions, count_)};
        const auto numbers = 3 * static_cast<std::size_t>(count_);
        const bool whole = vectors.positions.size() == numbers &&
                           vectors.velocities.size() == (has_velocities_ ? numbers : 0) &&
                           checksum(vectors.velocities, vectors.positions) == frame.checksum;
        if (!whole) {
            throw CheckpointError(
                fmt::format("the frame of step {} in '{}' is not what was written", frame.step, from.string()));
        }
        append(frame, vectors);
    }
}

void H5mdWriter::create_metadata(const TrajectoryOptions& options) {
    file_.create_group("h5md");
    file_.set_attribute("h5md", "version", std::vector<int>{1, 1});
    file_.create_group("h5md/author");
    file_.set_fixed_text("h5md/author", "name", options.author.empty() ? "unknown" : options.author);
    file_.create_group("h5md/creator");
    file_.set_fixed_text("h5md/creator", "name", "ljmd");
    file_.set_fixed_text("h5md/creator", "version", options.creator_version);
}

void H5mdWriter::create_parameters(const TrajectoryOptions& options) {
    const bool si = options.si.has_value();
    file_.create_group("parameters");
    if (!options.title.empty()) {
        file_.set_variable_text("parameters", "title", options.title);
    }
    const std::string units = "parameters/units";
    file_.create_group(units);
    // An unbounded system is not made of sigma and tau: its deck chose the units and did not name them.
    file_.set_variable_text(units, "length", si ? "nm" : has_box_ ? "sigma" : "unit of the deck");
    file_.set_variable_text(units, "time", si ? "ps" : has_box_ ? "tau" : "unit of the deck");
    file_.set_variable_text(units, "velocity", si ? "nm ps-1" : has_box_ ? "sigma/tau" : "unit of the deck");

    const std::string vmd = "parameters/vmd_structure";
    file_.create_group(vmd);
    file_.write_numbers(vmd + "/indexOfSpecies", std::vector<std::int64_t>{0});
    file_.write_texts(vmd + "/name", {si ? "Ar" : "X"});
    file_.write_texts(vmd + "/type", {si ? "Ar" : "X"});
    constexpr std::int64_t argon = 18;
    file_.write_numbers(vmd + "/atomicnumber", std::vector<std::int64_t>{si ? argon : 0});
    file_.write_numbers(vmd + "/mass", std::vector<double>{si ? options.si->dalton() : 1.0});
    file_.write_numbers(vmd + "/radius", std::vector<double>{0.5 * scale_.length});  // half a sigma
}

void H5mdWriter::create_particles(const State& first, bool si) {
    file_.create_group("particles");
    file_.create_group(particles);
    file_.create_group(particles + "/position");
    file_.create_series(step_, {frames_per_chunk});
    file_.create_series(time_, {frames_per_chunk});
    file_.create_series(position_, frame_chunk(count_));
    if (has_velocities_) {
        file_.create_group(particles + "/velocity");
        file_.create_series(velocity_, frame_chunk(count_));
        file_.link(step_.name, particles + "/velocity/step");
        file_.link(time_.name, particles + "/velocity/time");
    }
    if (si) {
        file_.set_variable_text(position_.name, "unit", "nm");
        file_.set_variable_text(time_.name, "unit", "ps");
        if (has_velocities_) {
            file_.set_variable_text(velocity_.name, "unit", "nm ps-1");
        }
    }
    std::vector<std::int64_t> ids;
    std::vector<double> masses;
    for (const Index i : first.index_of()) {
        ids.push_back(std::ssize(ids) + 1);
        masses.push_back(first.masses()[static_cast<std::size_t>(i)]);
    }
    file_.write_numbers(particles + "/species", std::vector<std::int64_t>(ids.size(), 0));
    file_.write_numbers(particles + "/id", ids);
    if (!si) {
        file_.write_numbers(particles + "/mass", masses);
    }
}

void H5mdWriter::create_box(bool si) {
    const std::string box = particles + "/box";
    file_.create_group(box);
    file_.set_attribute(box, "dimension", 3);
    file_.set_fixed_texts(box, "boundary", std::vector<std::string>(3, has_box_ ? "periodic" : "none"));
    if (has_box_) {
        file_.create_group(box + "/edges");
        file_.create_series(edges_, {frames_per_chunk, 3, 3});
        file_.link(step_.name, box + "/edges/step");
        file_.link(time_.name, box + "/edges/time");
        if (si) {
            file_.set_variable_text(edges_.name, "unit", "nm");
        }
    }
}

void H5mdWriter::write(const State& state) {
    if (state.count() != count_ || state.has_box() != has_box_) {
        throw ContractViolation("a trajectory keeps its number of atoms and its kind of box");
    }
    if (failed_) {
        throw FileError(fmt::format("cannot write '{}': an earlier write failed", file_.path().string()));
    }
    failed_ = true;  // until the frame is complete
    FramePlace frame{state.step, scale_.time * state.time, {}, {}, {}, 0};
    if (has_box_) {
        const Mat3 edges = (scale_.length * state.box().edges()).asDiagonal();
        std::copy_n(edges.data(), frame.edges.size(), frame.edges.begin());
    }
    Vectors vectors;
    if (has_velocities_) {
        const auto v = state.velocities();
        vectors.velocities = gathered(state, scale_.velocity, [&v](Index i) -> Vec3 { return v.col(i); });
    }
    vectors.positions = gathered(state, scale_.length, [&state](Index i) { return state.unwrapped(i); });
    append(frame, vectors);
    failed_ = false;
}

void H5mdWriter::append(const FramePlace& frame, const Vectors& vectors) {
    frames_.push_back(frame);
    FramePlace& place = frames_.back();
    file_.append(step_, &place.step);
    file_.append(time_, &place.time);
    if (has_box_) {
        file_.append(edges_, place.edges.data());
    }
    if (has_velocities_) {
        file_.append(velocity_, vectors.velocities.data());
        place.velocities = file_.places_of_last(velocity_);
    }
    // Positions go last: readers take the number of frames from them, so a frame that they count is complete.
    file_.append(position_, vectors.positions.data());
    place.positions = file_.places_of_last(position_);
    place.checksum = checksum(vectors.velocities, vectors.positions);
}

CommittedFrames H5mdWriter::commit() {
    file_.commit();
    return {0, frames_};
}

void H5mdWriter::close() {
    file_.close();
    if (failed_) {
        throw FileError(fmt::format("cannot write '{}': an earlier write failed", file_.path().string()));
    }
}

}  // namespace ljmd
