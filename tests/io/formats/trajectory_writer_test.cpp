#include "io/formats/trajectory_writer.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/formats/trajectory_reader.hpp"
#include "io/hdf5/hdf5_handle.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/options/registry.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// What each format holds is tested in tests/io/formats/trajectories; here, what all promise.

namespace {

int chunk_lookups = 0;

}  // namespace

/// In the place of HDF5's function, which looks through all chunks of a dataset.
extern "C" herr_t H5Dget_chunk_info_by_coord(hid_t dataset, const hsize_t* corner, unsigned* filters, haddr_t* place,
                                             hsize_t* bytes) {
    static const auto original =
        reinterpret_cast<decltype(&H5Dget_chunk_info_by_coord)>(::dlsym(RTLD_NEXT, "H5Dget_chunk_info_by_coord"));
    ++chunk_lookups;
    return original(dataset, corner, filters, place, bytes);
}

namespace {

State sample() {
    State state(3, Box(Vec3(4.0, 5.0, 6.0)));
    for (Index i = 0; i < 3; ++i) {
        state.write_positions().col(i) = Vec3(static_cast<double>(i), 0.5, 0.25);
        state.write_velocities().col(i) = Vec3(0.0, static_cast<double>(i), 0.0);
    }
    state.reorder({2, 0, 1});
    return state;
}

/// All that the frames of a file hold, as text.
std::string frames_of(const std::filesystem::path& path, const std::string& format) {
    if (format != "h5md") {
        return content_of(path);
    }
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, H5P_DEFAULT), H5Fclose);
    REQUIRE(file);
    std::string text;
    for (const char* name : {"position/step", "position/time", "position/value", "velocity/value", "force/value",
                             "potential_energy/value", "box/edges/value"}) {
        const std::string path_of_numbers = fmt::format("particles/trajectory/{}", name);
        const std::string element = path_of_numbers.substr(0, path_of_numbers.rfind('/'));
        if (H5Lexists(file.get(), element.c_str(), H5P_DEFAULT) <= 0) {
            continue;
        }
        const Hdf5Handle dataset(H5Dopen2(file.get(), path_of_numbers.c_str(), H5P_DEFAULT), H5Dclose);
        const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
        std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
        REQUIRE(H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0);
        text += fmt::format("{}: {}\n", name, fmt::join(numbers, " "));
    }
    return text;
}

}  // namespace

TEST_CASE("a trajectory file is there at once, in the place of an older one, and writing it leaves the state alone") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        INFO(format);
        const TemporaryFolder folder;
        const auto path = folder / "t";
        std::ofstream(path) << "something else";
        State state = sample();
        const State before = state;
        const auto writer = make_trajectory_writer(format, state, {.path = path, .velocities = true});
        REQUIRE(writer != nullptr);
        CHECK_THAT(content_of(path), !Contains("something else"));
        const auto empty = std::filesystem::file_size(path);
        writer->write(state);
        CHECK(std::filesystem::file_size(path) > empty);
        writer->close();
        CHECK_NOTHROW(writer->close());
        CHECK(folder.count_files() == 1);
        CHECK(state.positions() == before.positions());
        CHECK(state.velocities() == before.velocities());
        CHECK(state.ids() == before.ids());
        CHECK(state.order_version() == before.order_version());
    }
}

TEST_CASE("a trajectory is of one system") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        INFO(format);
        const TemporaryFolder folder;
        const State state = sample();
        const auto writer = make_trajectory_writer(format, state, {.path = folder / "t"});
        CHECK_THROWS_AS(writer->write(State(4, state.box())), ContractViolation);
        CHECK_THROWS_AS(writer->write(State(3)), ContractViolation);
        CHECK_THROWS_AS(writer->write(state, std::vector(3, 1.0)), ContractViolation);
        CHECK_NOTHROW(writer->write(state));
        writer->close();
        State forced = state;
        const auto full =
            make_trajectory_writer(format, state, {.path = folder / "full", .forces = true, .energies = true});
        CHECK_THROWS_AS(full->write(forced, std::vector(3, 1.0)), ContractViolation);  // forces of other positions
        forced.mark_forces_current();
        CHECK_THROWS_AS(full->write(forced), ContractViolation);
        CHECK_NOTHROW(full->write(forced, std::vector(3, 1.0)));
    }
}

TEST_CASE("a trajectory that cannot be created is an error that names it, a format that there is not is one too") {
    const TemporaryFolder folder;
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        CHECK_THROWS_AS(make_trajectory_writer(format, sample(), {.path = folder / "none" / "t"}), FileError);
        CHECK_THROWS_WITH(make_trajectory_writer(format, sample(), {.path = folder / "none" / "t"}),
                          Contains("none/t"));
    }
    CHECK_THROWS_AS(make_trajectory_writer("no such format", sample(), {.path = folder / "t"}), InputError);
    CHECK_THROWS_WITH(make_trajectory_writer("", sample(), {.path = folder / "t"}),
                      Contains("unknown trajectory format ''") && Contains("h5md") && Contains("xyz"));
    CHECK(folder.count_files() == 0);
}

TEST_CASE("a trajectory is continued from the frames that are kept, whether it was closed or not") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        for (const bool closed : {true, false}) {
            INFO(format << (closed ? ", closed" : ", left open"));
            const TemporaryFolder folder;
            const auto moved = [](Index step) {
                State state = sample();
                state.step = step;
                state.write_positions().col(0) += Vec3(0.0, 0.125 * static_cast<double>(step), 0.0);
                state.write_forces().setConstant(0.5 * static_cast<double>(step));
                state.mark_forces_current();
                return state;
            };
            const auto write = [&](const std::string& name, Index first, Index last,
                                   const std::optional<CommittedFrames>& kept) {
                auto writer = make_trajectory_writer(
                    format, sample(),
                    {.path = folder / name, .velocities = true, .forces = true, .energies = true, .kept = kept});
                CommittedFrames committed;
                for (Index step = first; step <= last; ++step) {
                    writer->write(moved(step), std::vector(3, -0.25 * static_cast<double>(step)));
                    if (step == 2) {
                        committed = writer->commit();
                    }
                }
                // The copy is what a kill leaves. HDF5 would find the file itself still open.
                const auto path = folder / name;
                const auto copy = folder / "copy";
                std::filesystem::copy_file(path, copy);
                writer->close();
                std::filesystem::rename(closed ? path : copy, path);
                std::filesystem::remove(copy);
                return committed;
            };
            write("whole", 0, 5, std::nullopt);
            const CommittedFrames kept = write("parts", 0, 4, std::nullopt);
            write("parts", 3, 5, kept);
            CHECK(frames_of(folder / "parts", format) == frames_of(folder / "whole", format));
            CHECK(frames_of(folder / "parts", format).size() > 0);
            CHECK(folder.count_files() == 2);
            if (closed) {
                CHECK((content_of(folder / "parts") == content_of(folder / "whole")));
            }
        }
    }
}

TEST_CASE("a trajectory that was resumed is committed as it was, before its first new frame") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        INFO(format);
        const TemporaryFolder folder;
        TrajectoryOptions options{.path = folder / "t", .velocities = true};
        auto writer = make_trajectory_writer(format, sample(), options);
        for (int frame = 0; frame < 70; ++frame) {
            writer->write(sample());
        }
        options.kept = writer->commit();
        writer->close();
        writer = make_trajectory_writer(format, sample(), options);
        const CommittedFrames again = writer->commit();
        CHECK(again.frames == options.kept->frames);
        CHECK(again.layout == options.kept->layout);
        CHECK(again.last.place == options.kept->last.place);
        CHECK(again.last.checksum == options.kept->last.checksum);
        writer->close();
    }
}

TEST_CASE("a trajectory that has lost frames is not continued and not touched") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        INFO(format);
        const TemporaryFolder folder;
        const auto path = folder / "t";
        const TrajectoryOptions options{.path = path, .kept = CommittedFrames{.bytes = 100000, .frames = 7}};
        CHECK_THROWS_AS(make_trajectory_writer(format, sample(), options), CheckpointError);
        CHECK(folder.count_files() == 0);
        auto writer = make_trajectory_writer(format, sample(), {.path = path});
        writer->write(sample());
        writer->close();
        const std::string before = content_of(path);
        CHECK_THROWS_AS(make_trajectory_writer(format, sample(), options), CheckpointError);
        CHECK(content_of(path) == before);
        CHECK(folder.count_files() == 1);
    }
}

TEST_CASE("formats are listed by name, in alphabetical order, with what they are called") {
    const auto formats = all_trajectory_formats();
    const std::vector<std::string> names = plugin_names(formats);
    CHECK(std::ranges::is_sorted(names));
    CHECK(std::ranges::adjacent_find(names) == names.end());
    CHECK(std::ranges::find(names, "csv") == names.end());  // the name of the table of few bodies
    for (const TrajectoryFormat& format : formats) {
        CHECK_FALSE(format.meaning.empty());
        CHECK_FALSE(format.si_units.empty());
    }
}

TEST_CASE("a format that is said to be read gives back what was written, to the last bit, and no other is read") {
    for (const TrajectoryFormat& format : all_trajectory_formats()) {
        INFO(format.name);
        const TemporaryFolder folder;
        State state = sample();
        state.write_positions().col(0) = Vec3(1.0 / 3.0, 17.0, -0.1);
        state.write_velocities().col(1) = Vec3(1.0 / 7.0, -1e-300, 2e10);
        state.wrap();
        state.step = 50;
        state.time = 0.1;
        const TrajectoryOptions options{.path = folder / "t", .velocities = true};
        const auto writer = make_trajectory_writer(format.name, state, options);
        writer->write(state);
        writer->close();
        if (!format.is_read) {
            CHECK_THROWS_AS(open_trajectory(folder / "t", std::nullopt), DataError);
            continue;
        }
        Frame frame;
        REQUIRE(open_trajectory(folder / "t", std::nullopt)->next(frame));
        const Configuration& found = frame.configuration;
        CHECK(found.edges == state.box().edges());
        CHECK(found.step == 50);
        CHECK(found.time == 0.1);
        const auto index_of = state.index_of();
        REQUIRE(found.positions.size() == 3);
        REQUIRE(found.velocities.size() == 3);
        for (std::size_t id = 0; id < 3; ++id) {
            CHECK(found.positions[id] == state.unwrapped(index_of[id]));
            CHECK(found.velocities[id] == Vec3(static_cast<const State&>(state).velocities().col(index_of[id])));
        }
    }
}

TEST_CASE("forces of a trajectory are read back in every unit, by id") {
    const SubstanceUnits argon(3.405e-10, 119.8 * 1.380649e-23, 39.948 * 1.66053906660e-27);
    for (const TrajectoryFormat& format : all_trajectory_formats()) {
        for (const auto& units : {std::optional<SubstanceUnits>{}, std::optional(argon)}) {
            if (!format.is_read) {
                continue;
            }
            INFO(format.name << (units ? " in SI units" : ""));
            const TemporaryFolder folder;
            State state = sample();
            for (Index i = 0; i < 3; ++i) {
                state.write_forces().col(i) = Vec3(1.0 / 3.0, static_cast<double>(i), -2e10);
            }
            state.mark_forces_current();
            const TrajectoryOptions options{.path = folder / "t", .velocities = true, .forces = true, .si = units};
            const auto writer = make_trajectory_writer(format.name, state, options);
            writer->write(state);
            writer->close();
            Frame frame;
            REQUIRE(open_trajectory(folder / "t", units)->next(frame));
            REQUIRE(frame.forces.size() == 3);
            const auto index_of = state.index_of();
            for (std::size_t id = 0; id < 3; ++id) {
                const Vec3 written = static_cast<const State&>(state).forces().col(index_of[id]);
                CHECK((frame.forces[id] - written).cwiseQuotient(Vec3(1.0, 1.0, 1e10)).norm() <
                      (units ? 1e-14 : 0.0) + 1e-300);
            }
        }
    }
}

TEST_CASE("forces that stand in a file with their own order of atoms come by id, with NaN for what is no number") {
    const TemporaryFolder folder;
    const auto forces_of = [&](const std::string& text) {
        std::ofstream(folder / "t") << text;
        Frame frame;
        static_cast<void>(open_trajectory(folder / "t", std::nullopt)->next(frame));
        return frame.forces;
    };
    const std::string xyz = "2\nLattice=\"4 0 0 0 5 0 0 0 6\" Properties=species:S:1:pos:R:3:forces:R:3:id:I:1\n";
    const std::string dump =
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 4\n0 5\n0 6\n"
        "ITEM: ATOMS id x y z fx fy fz\n";
    const std::vector<Vec3> expected{{1, 2, 3}, {4, 5, 6}};
    CHECK(forces_of(xyz + "X 1 1 1 4 5 6 2\nX 2 2 2 1 2 3 1\n") == expected);
    CHECK(forces_of(dump + "2 1 1 1 4 5 6\n1 2 2 2 1 2 3\n") == expected);
    CHECK(std::isnan(forces_of(xyz + "X 1 1 1 4 nan 6 2\nX 2 2 2 1 2 3 1\n").at(1)[1]));
    CHECK(std::isinf(forces_of(dump + "2 1 1 1 4 inf 6\n1 2 2 2 1 2 3\n").at(1)[1]));
}

namespace {

/// What this process has read and written so far, by the system's count.
struct Transfer {
    double bytes_read = 0.0;
    double bytes_written = 0.0;
    double writes = 0.0;

    static Transfer until_now() {
        std::ifstream file("/proc/self/io");
        Transfer all;
        std::string name;
        for (double number = 0.0; file >> name >> number;) {
            if (name == "rchar:") all.bytes_read = number;
            if (name == "wchar:") all.bytes_written = number;
            if (name == "syscw:") all.writes = number;
        }
        return all;
    }

    Transfer operator-(const Transfer& earlier) const {
        return {bytes_read - earlier.bytes_read, bytes_written - earlier.bytes_written, writes - earlier.writes};
    }
};

/// What so many frames of a trajectory cost.
struct Cost {
    Transfer writing;
    Transfer resuming;
    Transfer reading;
    std::size_t checkpoint = 0;  ///< bytes of what a checkpoint knows of the file
    int lookups = 0;             ///< of chunks, while it is written
};

Cost cost_of(const std::string& format, int frames) {
    const TemporaryFolder folder;
    const State state = sample();
    TrajectoryOptions options{.path = folder / "t", .velocities = true};
    Cost cost;
    auto writer = make_trajectory_writer(format, state, options);
    chunk_lookups = 0;
    const Transfer before = Transfer::until_now();
    for (int frame = 0; frame < frames; ++frame) {
        writer->write(state);
    }
    cost.writing = Transfer::until_now() - before;
    cost.lookups = chunk_lookups;
    options.kept = writer->commit();
    Archive archive;
    archive(*options.kept);
    cost.checkpoint = archive.bytes().size();
    writer->close();
    const Transfer closed = Transfer::until_now();
    make_trajectory_writer(format, state, options)->close();
    cost.resuming = Transfer::until_now() - closed;
    if (!find_plugin(all_trajectory_formats(), format, "format").is_read) {
        return cost;
    }
    const Transfer resumed = Transfer::until_now();
    const auto reader = open_trajectory(options.path.path(), std::nullopt);
    Frame frame;
    int found = 0;
    while (reader->next(frame)) {
        ++found;
    }
    CHECK(found == 1);  // frames of one step are counted once
    CHECK(reader->frames() == frames);
    cost.reading = Transfer::until_now() - resumed;
    return cost;
}

}  // namespace

TEST_CASE("a frame costs the same in a long trajectory as in a short one, and so does a resume") {
    if (Transfer::until_now().bytes_read == 0.0) {
        WARN("this system does not count what a process reads and writes");
        return;
    }
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        INFO(format);
        constexpr int frames = 512;
        const Cost one = cost_of(format, frames);
        const Cost four = cost_of(format, 4 * frames);
        CHECK(four.writing.bytes_written < 4.2 * one.writing.bytes_written);
        CHECK(four.writing.writes < 4.2 * one.writing.writes);
        CHECK(four.writing.bytes_read < 4.2 * one.writing.bytes_read + 4096.0);
        CHECK(four.reading.bytes_read <= 4.2 * one.reading.bytes_read);
        // Nothing for a frame: records about chunks, if anything.
        CHECK(one.resuming.bytes_written < 16.0 * 1024.0);
        CHECK(four.resuming.bytes_written < one.resuming.bytes_written + 4096.0);
        CHECK(four.resuming.bytes_read < one.resuming.bytes_read + 4096.0);
        CHECK(four.checkpoint == one.checkpoint);
        CHECK(four.lookups == 0);
        UNSCOPED_INFO(format << " " << one.resuming.bytes_written << " " << four.resuming.bytes_written << " "
                             << one.resuming.bytes_read << " " << four.resuming.bytes_read << " "
                             << one.writing.bytes_read << " " << four.writing.bytes_read);
    }
}

TEST_CASE("the bytes that a trajectory was said to take are about those of its file") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        for (const Index atoms : {3, 108, 4000}) {
            for (const Index frames : {1, 10, 100}) {
                for (const AtomColumns& columns :
                     {AtomColumns{}, AtomColumns{.velocities = true}, AtomColumns{.forces = true},
                      AtomColumns{.velocities = true, .forces = true, .energies = true}}) {
                    State state(atoms, Box(Vec3(7.0, 7.0, 7.0)));
                    state.write_positions().setRandom();
                    state.write_velocities().setRandom();
                    state.write_forces().setRandom();
                    state.mark_forces_current();
                    const std::vector<double> energies(
                        columns.energies ? static_cast<std::size_t>(atoms) : std::size_t{0}, -6.123456789012345);
                    const TemporaryFolder folder;
                    const std::filesystem::path path = folder / "a.trajectory";
                    const auto writer = make_trajectory_writer(format, state,
                                                               {.path = path,
                                                                .velocities = columns.velocities,
                                                                .forces = columns.forces,
                                                                .energies = columns.energies});
                    for (Index frame = 0; frame < frames; ++frame) {
                        writer->write(state, energies);
                    }
                    writer->close();
                    const double said = trajectory_bytes(format, atoms, frames, columns);
                    const auto taken = static_cast<double>(std::filesystem::file_size(path));
                    CAPTURE(format, atoms, frames, columns.velocities, columns.forces, said, taken);
                    CHECK(said < 1.3 * taken);
                    CHECK(said > taken / 1.3);
                }
            }
        }
    }
}
