#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "io/formats/unit_scale.hpp"
#include "io/hdf5/hdf5_output.hpp"
#include "ljmd/core/errors.hpp"
#include "model/atoms_by_id.hpp"

namespace ljmd {

namespace {

const std::string particles = "particles/trajectory";

/// Chunk length of arrays with one small entry per frame; no chunk holds more frames.
constexpr hsize_t max_frames_per_chunk = 64;

/// A frame above 1 MiB is divided into equal pieces below that.
Index atoms_per_chunk(Index atoms) {
    constexpr Index bytes_per_atom = 3 * sizeof(double);
    constexpr Index max_bytes = Index{1} << 20;
    const Index pieces = std::max<Index>(1, (atoms * bytes_per_atom + max_bytes - 1) / max_bytes);
    return std::max<Index>(1, (atoms + pieces - 1) / pieces);
}

/// Frames per chunk of vectors: a power of two, so that it divides the chunk length of small entries.
hsize_t frames_per_chunk(Index atoms) {
    constexpr Index bytes_per_atom = 3 * sizeof(double);
    constexpr Index max_bytes = Index{64} << 10;
    hsize_t frames = max_frames_per_chunk;
    while (frames > 1 && static_cast<Index>(frames) * atoms * bytes_per_atom > max_bytes) {
        frames /= 2;
    }
    return frames;
}

std::vector<hsize_t> vector_chunk(Index atoms) {
    return {frames_per_chunk(atoms), static_cast<hsize_t>(atoms_per_chunk(atoms)), 3};
}

/// (N, 3) in row-major order.
std::vector<double> scaled(const std::vector<Vec3>& vectors, double scale) {
    std::vector<double> result;
    result.reserve(3 * vectors.size());
    for (const Vec3& vector : vectors) {
        const Vec3 v = scale * vector;
        result.insert(result.end(), {v[0], v[1], v[2]});
    }
    return result;
}

/// Checksum of the part of a frame that is in its first chunk.
std::uint64_t checksum(const std::vector<double>& first_positions) {
    return XXH3_64bits(first_positions.data(), first_positions.size() * sizeof(double));
}

/// The numbers at this offset in a file; zeros after its end. @throws DataError
std::vector<double> numbers_at(const std::filesystem::path& path, std::uint64_t place, std::size_t count) {
    std::vector<double> numbers(count);
    std::ifstream file = open_input(path);
    go_to(file, static_cast<std::streamoff>(place));
    file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(count * sizeof(double)));
    if (file.bad()) {
        throw DataError(fmt::format("{}: {}", path.string(), why_reading_failed()));
    }
    return numbers;
}

class H5mdWriter : public TrajectoryWriter {
  public:
    H5mdWriter(const State& first, const TrajectoryOptions& options);
    CommittedFrames commit() override;
    void close() override;

  private:
    void append(const State& state, std::span<const double> energies) override;
    void require_kept(const TrajectoryOptions& options);

    void create_metadata(const TrajectoryOptions& options);
    void create_parameters(const TrajectoryOptions& options);
    void create_box(bool si);
    void create_particles(const State& first, bool si);
    void create_series_of_atoms(const std::string& name, Hdf5Output::Series& series, const std::vector<hsize_t>& chunk,
                                const std::string& unit);

    Index count_;
    bool has_box_;
    bool has_velocities_;
    bool has_forces_;
    bool has_energies_;
    bool failed_ = false;
    FrameMark last_;
    UnitScale scale_;
    double energy_scale_;  ///< epsilon in the unit of the file
    Hdf5Output file_;
    Hdf5Output::Series step_;
    Hdf5Output::Series time_;
    Hdf5Output::Series edges_;
    Hdf5Output::Series velocity_;
    Hdf5Output::Series force_;
    Hdf5Output::Series energy_;
    Hdf5Output::Series position_;
};

H5mdWriter::H5mdWriter(const State& first, const TrajectoryOptions& options)
    : TrajectoryWriter(first, options),
      count_(first.total()),
      has_box_(first.has_box()),
      has_velocities_(options.velocities),
      has_forces_(options.forces),
      has_energies_(options.energies),
      scale_(unit_scale(options.si, 1.0)),
      energy_scale_(options.si ? options.si->kilojoule_per_mole() : 1.0),
      file_(options.path),
      step_{particles + "/position/step", {}, H5T_NATIVE_INT64},
      time_{particles + "/position/time", {}, H5T_NATIVE_DOUBLE},
      edges_{particles + "/box/edges/value", {3, 3}, H5T_NATIVE_DOUBLE},
      velocity_{particles + "/velocity/value", {static_cast<hsize_t>(count_), 3}, H5T_NATIVE_DOUBLE},
      force_{particles + "/force/value", {static_cast<hsize_t>(count_), 3}, H5T_NATIVE_DOUBLE},
      energy_{particles + "/potential_energy/value", {static_cast<hsize_t>(count_)}, H5T_NATIVE_DOUBLE},
      position_{particles + "/position/value", {static_cast<hsize_t>(count_), 3}, H5T_NATIVE_DOUBLE} {
    create_metadata(options);
    create_parameters(options);
    create_particles(first, options.si.has_value());
    create_box(options.si.has_value());
    if (!options.kept) {
        file_.start_appending();
        return;
    }
    require_kept(options);
    std::vector<Hdf5Output::Series*> series{&step_, &time_};  // in the order of write()
    if (has_box_) {
        series.push_back(&edges_);
    }
    if (has_velocities_) {
        series.push_back(&velocity_);
    }
    if (has_forces_) {
        series.push_back(&force_);
    }
    if (has_energies_) {
        series.push_back(&energy_);
    }
    series.push_back(&position_);
    file_.continue_appending(series, static_cast<hsize_t>(options.kept->frames), frames_per_chunk(count_));
    last_ = options.kept->last;
}

/// Check that the file is the committed one, before it is changed.
void H5mdWriter::require_kept(const TrajectoryOptions& options) {
    const CommittedFrames& kept = *options.kept;
    const std::string name = options.path.path().string();
    require_bytes(options.path, kept.bytes);
    if (kept.layout != file_.layout()) {
        throw CheckpointError(
            fmt::format("'{}' was written with another version of HDF5 than this one, or for another run", name));
    }
    const Index frame_bytes = 3 * static_cast<Index>(sizeof(double)) * count_;
    if (kept.frames < 0 || kept.frames > kept.bytes / frame_bytes) {
        throw CheckpointError(fmt::format("'{}' is too short for {} frames", name, kept.frames));
    }
    if (kept.frames == 0) {
        return;
    }
    const auto numbers = 3 * static_cast<std::size_t>(atoms_per_chunk(count_));
    if (checksum(numbers_at(options.path.path(), kept.last.place, numbers)) != kept.last.checksum) {
        throw CheckpointError(
            fmt::format("the frame of step {} in '{}' is not what was written", kept.last.step, name));
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
    // The deck of an unbounded system chose the units and did not name them.
    file_.set_variable_text(units, "length", si ? "nm" : has_box_ ? "sigma" : "unit of the deck");
    file_.set_variable_text(units, "time", si ? "ps" : has_box_ ? "tau" : "unit of the deck");
    file_.set_variable_text(units, "velocity", si ? "nm ps-1" : has_box_ ? "sigma/tau" : "unit of the deck");
    if (has_forces_) {
        file_.set_variable_text(units, "force", si ? "kJ mol-1 nm-1" : has_box_ ? "epsilon/sigma" : "unit of the deck");
    }
    if (has_energies_) {
        file_.set_variable_text(units, "energy", si ? "kJ mol-1" : has_box_ ? "epsilon" : "unit of the deck");
    }

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
    file_.create_series(step_, {max_frames_per_chunk});
    file_.create_series(time_, {max_frames_per_chunk});
    file_.create_series(position_, vector_chunk(count_));
    if (si) {
        file_.set_variable_text(position_.name, "unit", "nm");
        file_.set_variable_text(time_.name, "unit", "ps");
    }
    const auto unit = [si](const char* name) { return si ? std::string(name) : std::string(); };
    if (has_velocities_) {
        create_series_of_atoms("velocity", velocity_, vector_chunk(count_), unit("nm ps-1"));
    }
    if (has_forces_) {
        create_series_of_atoms("force", force_, vector_chunk(count_), unit("kJ mol-1 nm-1"));
    }
    if (has_energies_) {
        const std::vector<hsize_t> chunk = vector_chunk(count_);
        create_series_of_atoms("potential_energy", energy_, {chunk[0], chunk[1]}, unit("kJ mol-1"));
    }
    std::vector<std::int64_t> ids;
    std::vector<double> masses;
    visit_by_id(first, {.masses = true},
                [&](const AtomPiece& piece) { masses.insert(masses.end(), piece.masses.begin(), piece.masses.end()); });
    ids.resize(masses.size());
    std::iota(ids.begin(), ids.end(), 1);
    file_.write_numbers(particles + "/species", std::vector<std::int64_t>(ids.size(), 0));
    file_.write_numbers(particles + "/id", ids);
    if (!si) {
        file_.write_numbers(particles + "/mass", masses);
    }
}

/// An element of the particles, at the steps and times of the positions.
/// @param unit  empty: none
void H5mdWriter::create_series_of_atoms(const std::string& name, Hdf5Output::Series& series,
                                        const std::vector<hsize_t>& chunk, const std::string& unit) {
    const std::string group = particles + "/" + name;
    file_.create_group(group);
    file_.create_series(series, chunk);
    file_.link(step_.name, group + "/step");
    file_.link(time_.name, group + "/time");
    if (!unit.empty()) {
        file_.set_variable_text(series.name, "unit", unit);
    }
}

void H5mdWriter::create_box(bool si) {
    const std::string box = particles + "/box";
    file_.create_group(box);
    file_.set_attribute(box, "dimension", 3);
    file_.set_fixed_texts(box, "boundary", std::vector<std::string>(3, has_box_ ? "periodic" : "none"));
    if (has_box_) {
        file_.create_group(box + "/edges");
        file_.create_series(edges_, {max_frames_per_chunk, 3, 3});
        file_.link(step_.name, box + "/edges/step");
        file_.link(time_.name, box + "/edges/time");
        if (si) {
            file_.set_variable_text(edges_.name, "unit", "nm");
        }
    }
}

void H5mdWriter::append(const State& state, std::span<const double> energies) {
    if (failed_) {
        throw FileError(fmt::format("cannot write '{}': an earlier write failed", file_.path().string()));
    }
    failed_ = true;  // reset when the frame is complete
    const std::int64_t step = state.step;
    const double time = scale_.time * state.time;
    file_.append(step_, &step);
    file_.append(time_, &time);
    if (has_box_) {
        const Mat3 edges = (scale_.length * state.box().edges()).asDiagonal();
        file_.append(edges_, edges.data());
    }
    FrameMark mark{.step = step};
    const auto append_vectors = [&](Hdf5Output::Series& series, const AtomParts& parts, const auto& vectors_of) {
        file_.append_in_parts(series, [&](const Hdf5Output::WritePart& write) {
            const auto pass_on = [&](const AtomPiece& piece) {
                const std::vector<double> numbers = vectors_of(piece);
                write(static_cast<hsize_t>(piece.first), static_cast<hsize_t>(piece.count), numbers.data());
                mark.checksum = piece.first == 0 ? checksum(numbers) : mark.checksum;
            };
            visit_by_id(state, parts, pass_on, atoms_per_chunk(count_));
        });
    };
    if (has_velocities_) {
        append_vectors(velocity_, {.velocities = true},
                       [&](const AtomPiece& piece) { return scaled(piece.velocities, scale_.velocity); });
    }
    if (has_forces_) {
        append_vectors(force_, {.forces = true},
                       [&](const AtomPiece& piece) { return scaled(piece.forces, energy_scale_ / scale_.length); });
    }
    if (has_energies_) {
        std::vector<double> in_unit(energies.begin(), energies.end());
        for (double& energy : in_unit) {
            energy *= energy_scale_;
        }
        file_.append(energy_, in_unit.data());
    }
    // Positions go last: readers take the number of frames from them, so a frame that they count is complete.
    append_vectors(position_, {.positions = true},
                   [&](const AtomPiece& piece) { return scaled(piece.unwrapped(state), scale_.length); });
    last_ = mark;
    failed_ = false;
}

CommittedFrames H5mdWriter::commit() {
    const std::int64_t bytes = file_.commit();
    if (position_.length > 0) {
        last_.place = file_.place_of_last(position_);
    }
    return {bytes, static_cast<std::int64_t>(position_.length), file_.layout(), last_};
}

void H5mdWriter::close() {
    file_.close();
    if (failed_) {
        throw FileError(fmt::format("cannot write '{}': an earlier write failed", file_.path().string()));
    }
}

double h5md_bytes(Index atoms, Index frames, const AtomColumns& columns) {
    constexpr double metadata = 16e3;
    constexpr double of_atom = 3.0 * 8.0;   // species, id, mass
    constexpr double small_entries = 88.0;  // of a frame: step, time, edges
    const auto allotted = [frames](hsize_t chunk) {
        const auto length = static_cast<Index>(chunk);
        const Index chunks = (frames + length - 1) / length;
        return static_cast<double>(chunks * length);
    };
    const double vectors = 1.0 + (columns.velocities ? 1.0 : 0.0) + (columns.forces ? 1.0 : 0.0);
    const double numbers = 3.0 * vectors + (columns.energies ? 1.0 : 0.0);
    const double frame = numbers * sizeof(double) * static_cast<double>(atoms);
    return metadata + of_atom * static_cast<double>(atoms) + small_entries * allotted(max_frames_per_chunk) +
           frame * allotted(frames_per_chunk(atoms));
}

}  // namespace

/// A trajectory in H5MD 1.1 (P. de Buyl et al. (2014), doi:10.1016/j.cpc.2014.01.018), in the subset that MDAnalysis,
/// VMD and h5py all read:
///
///     h5md                              version [1, 1], author, creator
///     parameters/units                  attributes length, time, velocity: names of the units
///     parameters/vmd_structure          species for VMD: indexOfSpecies, name, type, atomicnumber, mass, radius
///     particles/trajectory/species, id  (N) fixed; ids count from 1
///     particles/trajectory/mass         (N) fixed; reduced files only
///     particles/trajectory/box          dimension, boundary; edges/value (F, 3, 3), a matrix: vectors are misread
///     particles/trajectory/position     step (F), time (F), value (F, N, 3), unwrapped
///     particles/trajectory/velocity     when asked for
///     particles/trajectory/force        when asked for
///     particles/trajectory/potential_energy  value (F, N), energies of the atoms, when asked for
///
/// step and time of the others are hard links to position's. Files in SI units have `unit` attributes nm, ps,
/// nm ps-1, kJ mol-1 nm-1 and kJ mol-1; reduced files have none, because readers refuse unknown units.
///
/// A chunk holds up to 64 frames and up to 64 KiB; larger frames have chunks of their own, those above 1 MiB several.
/// So HDF5's records of chunks are small, and their number grows with the number of chunks, not of frames.
///
/// An interrupted file is continued in place: HDF5's records are written again (Hdf5Output::continue_appending), frames
/// are not touched.
TrajectoryFormat h5md() {
    return {.name = "h5md",
            .meaning = "H5MD 1.1",
            .si_units = "nm, ps",
            .is_read = true,
            .make = [](const State& first, const TrajectoryOptions& options) -> std::unique_ptr<TrajectoryWriter> {
                return std::make_unique<H5mdWriter>(first, options);
            },
            .bytes = h5md_bytes};
}

}  // namespace ljmd
