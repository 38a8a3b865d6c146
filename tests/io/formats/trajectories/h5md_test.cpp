#include <cmath>
#include <numeric>
#include <vector>

#include "io/formats/trajectory_writer.hpp"
#include "io/hdf5/hdf5_handle.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/units.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

/// Read by the leak sanitizer, where there is one: HDF5 loses some memory of its own when it fails to write a file.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT: the name is not ours
    return "leak:libhdf5";
}

namespace {

const std::string group = "particles/trajectory/";

/// Reads a file back through the C API, as any program would.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& path, unsigned flags = H5F_ACC_RDONLY)
        : file_(H5Fopen(path.c_str(), flags, H5P_DEFAULT), H5Fclose) {
        REQUIRE(file_);
    }

    [[nodiscard]] bool has(const std::string& name) const {
        const Hdf5Silence silence;
        return static_cast<bool>(Hdf5Handle(H5Oopen(file_.get(), name.c_str(), H5P_DEFAULT), H5Oclose));
    }

    [[nodiscard]] std::vector<hsize_t> shape(const std::string& name) const {
        const Hdf5Handle dataset = open(name);
        const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
        std::vector<hsize_t> extent(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.get())));
        H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
        return extent;
    }

    [[nodiscard]] std::vector<hsize_t> chunk(const std::string& name) const {
        const Hdf5Handle creation(H5Dget_create_plist(open(name).get()), H5Pclose);
        std::vector<hsize_t> extent(shape(name).size());
        H5Pget_chunk(creation.get(), static_cast<int>(extent.size()), extent.data());
        return extent;
    }

    [[nodiscard]] bool has_type(const std::string& name, hid_t type) const {
        const Hdf5Handle found(H5Dget_type(open(name).get()), H5Tclose);
        return H5Tequal(found.get(), type) > 0;
    }

    [[nodiscard]] std::vector<double> numbers(const std::string& name) const {
        const auto extent = shape(name);
        std::vector<double> values(std::accumulate(extent.begin(), extent.end(), hsize_t{1}, std::multiplies<>()));
        REQUIRE(H5Dread(open(name).get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
        return values;
    }

    /// Entry `frame` of a series.
    [[nodiscard]] std::vector<double> frame(const std::string& name, std::size_t frame) const {
        const auto all = numbers(name);
        const auto size = static_cast<std::ptrdiff_t>(all.size() / shape(name)[0]);
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(frame) * size;
        return {begin, begin + size};
    }

    [[nodiscard]] haddr_t address(const std::string& name) const {
        H5O_info_t info;
        REQUIRE(H5Oget_info_by_name2(file_.get(), name.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) >= 0);
        return info.addr;
    }

    [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const {
        return H5Aexists_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
    }

    [[nodiscard]] bool is_variable_text(const std::string& object, const std::string& name) const {
        const Hdf5Handle type(H5Aget_type(attribute(object, name).get()), H5Tclose);
        return H5Tis_variable_str(type.get()) > 0;
    }

    [[nodiscard]] std::string variable_text(const std::string& object, const std::string& name) const {
        const Hdf5Handle found = attribute(object, name);
        const Hdf5Handle type(H5Aget_type(found.get()), H5Tclose);
        char* characters = nullptr;
        REQUIRE(H5Aread(found.get(), type.get(), &characters) >= 0);
        const std::string text = characters;
        H5free_memory(characters);
        return text;
    }

    /// Fixed-length texts end to end, zeros taken out.
    [[nodiscard]] std::string fixed_texts(const std::string& object, const std::string& name) const {
        const Hdf5Handle found = attribute(object, name);
        const Hdf5Handle type(H5Aget_type(found.get()), H5Tclose);
        std::string text(H5Aget_storage_size(found.get()), '\0');
        REQUIRE(H5Aread(found.get(), type.get(), text.data()) >= 0);
        std::erase(text, '\0');
        return text;
    }

    [[nodiscard]] std::vector<int> integers(const std::string& object, const std::string& name) const {
        const Hdf5Handle found = attribute(object, name);
        std::vector<int> values(H5Aget_storage_size(found.get()) / sizeof(int));
        REQUIRE(H5Aread(found.get(), H5T_NATIVE_INT, values.data()) >= 0);
        return values;
    }

  private:
    [[nodiscard]] Hdf5Handle open(const std::string& name) const {
        Hdf5Handle dataset(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
        INFO(name);
        REQUIRE(dataset);
        return dataset;
    }
    [[nodiscard]] Hdf5Handle attribute(const std::string& object, const std::string& name) const {
        Hdf5Handle found(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
        INFO(object + " " + name);
        REQUIRE(found);
        return found;
    }

    Hdf5Handle file_;
};

/// Three atoms, in another order in memory at every odd step; some leave the box, which grows.
State sample(Index step, bool bounded = true) {
    const auto s = static_cast<double>(step);
    const Box box(Vec3(4.0 + s, 5.0, 6.5));
    State state(3, bounded ? std::optional(box) : std::nullopt);
    for (Index id = 0; id < 3; ++id) {
        const auto k = static_cast<double>(id);
        state.write_positions().col(id) = Vec3(0.5 + k + 3.0 * s, 1.0 - 0.25 * s * k, -2.0 * k);
        state.write_velocities().col(id) = Vec3(k, -s, 0.1 * k);
        state.write_masses()[static_cast<std::size_t>(id)] = 1.0 + k;
    }
    if (bounded) {
        state.wrap();
    }
    state.reorder(step % 2 == 0 ? std::vector<Index>{2, 0, 1} : std::vector<Index>{1, 2, 0});
    state.time = 0.3 * s;
    state.step = 10 * step;
    return state;
}

std::vector<double> expected_positions(Index step, double scale = 1.0) {
    const auto s = static_cast<double>(step);
    std::vector<double> result;
    for (int k = 0; k < 3; ++k) {
        for (const double x : {0.5 + k + 3.0 * s, 1.0 - 0.25 * s * k, -2.0 * k}) {
            result.push_back(scale * x);
        }
    }
    return result;
}

SubstanceUnits argon() {
    constexpr double boltzmann = 1.380649e-23;
    constexpr double dalton = 1.66053906660e-27;
    return {3.405e-10, 119.8 * boltzmann, 39.948 * dalton};
}

void write_frames(const TrajectoryOptions& options, Index frames, bool bounded = true) {
    const auto writer = make_trajectory_writer("h5md", sample(0, bounded), options);
    for (Index step = 0; step < frames; ++step) {
        writer->write(sample(step, bounded));
    }
    writer->close();
}

}  // namespace

TEST_CASE("an H5MD file holds every frame exactly, atoms by id, positions unwrapped") {
    const TemporaryFolder folder;
    write_frames({.path = folder / "a.h5md", .velocities = true}, 3);
    const Reader file(folder / "a.h5md");
    CHECK(file.shape(group + "position/value") == std::vector<hsize_t>{3, 3, 3});
    CHECK(file.numbers(group + "position/step") == std::vector<double>{0, 10, 20});
    CHECK(file.numbers(group + "position/time") == std::vector<double>{0.0, 0.3, 0.6});
    CHECK(file.has_type(group + "position/step", H5T_STD_I64LE));
    CHECK(file.has_type(group + "position/time", H5T_IEEE_F64LE));
    CHECK(file.has_type(group + "position/value", H5T_IEEE_F64LE));
    for (Index step = 0; step < 3; ++step) {
        const auto f = static_cast<std::size_t>(step);
        const auto s = static_cast<double>(step);
        CHECK(file.frame(group + "position/value", f) == expected_positions(step));
        CHECK(file.frame(group + "velocity/value", f) == std::vector<double>{0, -s, 0, 1, -s, 0.1, 2, -s, 0.2});
        CHECK(file.frame(group + "box/edges/value", f) == std::vector<double>{4 + s, 0, 0, 0, 5, 0, 0, 0, 6.5});
    }
    CHECK(file.numbers(group + "id") == std::vector<double>{1, 2, 3});
    CHECK(file.numbers(group + "species") == std::vector<double>{0, 0, 0});
    CHECK(file.numbers(group + "mass") == std::vector<double>{1, 2, 3});
    CHECK_FALSE(file.has(group + "image"));
}

TEST_CASE("step and time of box and velocity are those of position") {
    const TemporaryFolder folder;
    write_frames({.path = folder / "a.h5md", .velocities = true}, 1);
    const Reader file(folder / "a.h5md");
    const auto step = file.address(group + "position/step");
    const auto time = file.address(group + "position/time");
    CHECK(step != time);
    for (const std::string element : {"box/edges", "velocity"}) {
        CHECK(file.address(group + element + "/step") == step);
        CHECK(file.address(group + element + "/time") == time);
    }
}

TEST_CASE("the groups of the standard are there") {
    const TemporaryFolder folder;
    write_frames({.path = folder / "a.h5md", .creator_version = "1.2.3", .author = "Séverine", .title = "t"}, 1);
    const Reader file(folder / "a.h5md");
    CHECK(file.integers("h5md", "version") == std::vector<int>{1, 1});
    CHECK(file.fixed_texts("h5md/author", "name") == "Séverine");
    CHECK(file.fixed_texts("h5md/creator", "name") == "ljmd");
    CHECK(file.fixed_texts("h5md/creator", "version") == "1.2.3");
    CHECK_FALSE(file.is_variable_text("h5md/author", "name"));
    CHECK_FALSE(file.is_variable_text("h5md/creator", "version"));
    CHECK(file.integers(group + "box", "dimension") == std::vector<int>{3});
    CHECK(file.fixed_texts(group + "box", "boundary") == "periodicperiodicperiodic");
    CHECK_FALSE(file.is_variable_text(group + "box", "boundary"));
    CHECK(file.variable_text("parameters", "title") == "t");
    CHECK_FALSE(file.has(group + "velocity"));
}

TEST_CASE("an H5MD file without an author or a version is still legal") {
    const TemporaryFolder folder;
    write_frames({.path = folder / "a.h5md"}, 1);
    const Reader file(folder / "a.h5md");
    CHECK(file.fixed_texts("h5md/author", "name") == "unknown");
    CHECK(file.fixed_texts("h5md/creator", "version").empty());
    CHECK_FALSE(file.has_attribute("parameters", "title"));
}

TEST_CASE("SI files are in nm and ps and say so, reduced files say nothing that readers refuse") {
    const TemporaryFolder folder;
    const double tau = 3.405e-10 * std::sqrt(39.948 * 1.66053906660e-27 / (119.8 * 1.380649e-23)) / 1e-12;
    write_frames({.path = folder / "si.h5md", .velocities = true, .si = argon()}, 2);
    const Reader si(folder / "si.h5md");
    CHECK(si.variable_text(group + "position/value", "unit") == "nm");
    CHECK(si.variable_text(group + "position/time", "unit") == "ps");
    CHECK(si.variable_text(group + "velocity/value", "unit") == "nm ps-1");
    CHECK(si.variable_text(group + "box/edges/value", "unit") == "nm");
    CHECK(si.variable_text("parameters/units", "length") == "nm");
    CHECK(si.is_variable_text(group + "position/value", "unit"));
    CHECK_THAT(si.frame(group + "position/value", 1), Catch::Approx(expected_positions(1, 0.3405)).epsilon(1e-14));
    CHECK(si.numbers(group + "position/time")[1] == Approx(0.3 * tau).epsilon(1e-14));
    CHECK(si.frame(group + "velocity/value", 1)[6] == Approx(2.0 * 0.3405 / tau).epsilon(1e-14));
    CHECK(si.frame(group + "box/edges/value", 1)[0] == Approx(5.0 * 0.3405).epsilon(1e-14));
    CHECK(si.numbers("parameters/vmd_structure/mass")[0] == Approx(39.948));

    write_frames({.path = folder / "reduced.h5md", .velocities = true}, 2);
    const Reader reduced(folder / "reduced.h5md");
    for (const std::string name : {"position/value", "position/time", "velocity/value", "box/edges/value", "mass"}) {
        CHECK_FALSE(reduced.has_attribute(group + name, "unit"));
    }
    CHECK(reduced.variable_text("parameters/units", "length") == "sigma");
    CHECK(reduced.variable_text("parameters/units", "time") == "tau");
    CHECK(reduced.variable_text("parameters/units", "velocity") == "sigma/tau");
    CHECK(reduced.numbers("parameters/vmd_structure/indexOfSpecies") == std::vector<double>{0});
}

TEST_CASE("an unbounded system has no edges") {
    const TemporaryFolder folder;
    write_frames({.path = folder / "a.h5md"}, 2, false);
    const Reader file(folder / "a.h5md");
    CHECK(file.fixed_texts(group + "box", "boundary") == "nonenonenone");
    CHECK_FALSE(file.has(group + "box/edges"));
    CHECK(file.frame(group + "position/value", 1) == expected_positions(1));
}

TEST_CASE("a chunk holds up to 64 frames and 64 KiB, a larger frame is one, up to a mebibyte") {
    const TemporaryFolder folder;
    const auto chunk_of = [&folder](Index atoms) {
        const State state(atoms, Box(Vec3(9.0, 9.0, 9.0)));
        make_trajectory_writer("h5md", state, {.path = folder / "a.h5md"})->close();
        return Reader(folder / "a.h5md").chunk(group + "position/value");
    };
    CHECK(chunk_of(1) == std::vector<hsize_t>{64, 1, 3});
    CHECK(chunk_of(42) == std::vector<hsize_t>{64, 42, 3});
    CHECK(chunk_of(108) == std::vector<hsize_t>{16, 108, 3});
    CHECK(chunk_of(864) == std::vector<hsize_t>{2, 864, 3});
    CHECK(chunk_of(2000) == std::vector<hsize_t>{1, 2000, 3});
    CHECK(chunk_of(43690) == std::vector<hsize_t>{1, 43690, 3});
    CHECK(chunk_of(43691) == std::vector<hsize_t>{1, 21846, 3});
}

TEST_CASE("a frame larger than a chunk and a run longer than a chunk of times come back exactly") {
    const TemporaryFolder folder;
    State large(50001, Box(Vec3(64.0, 64.0, 64.0)));
    for (Index i = 0; i < large.count(); ++i) {
        large.write_positions().col(i) = Vec3::Constant(static_cast<double>(i) / 1024.0);
    }
    const auto writer = make_trajectory_writer("h5md", large, {.path = folder / "large.h5md"});
    writer->write(large);
    writer->close();
    const auto values = Reader(folder / "large.h5md").frame(group + "position/value", 0);
    std::vector<double> expected;
    for (int i = 0; i < 50001; ++i) {
        expected.insert(expected.end(), 3, i / 1024.0);
    }
    CHECK((values == expected));  // in brackets: not to be printed

    write_frames({.path = folder / "long.h5md"}, 200);
    const Reader file(folder / "long.h5md");
    CHECK(file.numbers(group + "position/step").back() == 1990.0);
    CHECK(file.frame(group + "position/value", 150) == expected_positions(150));
}

TEST_CASE("a frame is in the file when write returns: another reader sees it, a copy holds it") {
    const TemporaryFolder folder;
    const auto writer = make_trajectory_writer("h5md", sample(0), {.path = folder / "a.h5md", .velocities = true});
    for (Index step = 0; step < 70; ++step) {
        writer->write(sample(step));
        // The copy is what a kill would leave.
        std::filesystem::copy_file(folder / "a.h5md", folder / "copy.h5md",
                                   std::filesystem::copy_options::overwrite_existing);
        const Reader copy(folder / "copy.h5md", H5F_ACC_RDONLY | H5F_ACC_SWMR_READ);
        const auto f = static_cast<std::size_t>(step);
        REQUIRE(copy.shape(group + "position/value")[0] == f + 1);
        REQUIRE(copy.frame(group + "position/value", f) == expected_positions(step));
        REQUIRE(copy.shape(group + "velocity/value")[0] == f + 1);
        REQUIRE(copy.shape(group + "box/edges/value")[0] == f + 1);
        REQUIRE(copy.numbers(group + "position/step").back() == 10.0 * static_cast<double>(step));
    }
}

TEST_CASE("a writer destroyed without close leaves a sound file") {
    const TemporaryFolder folder;
    make_trajectory_writer("h5md", sample(0), {.path = folder / "a.h5md"})->write(sample(0));
    CHECK(Reader(folder / "a.h5md").shape(group + "position/value")[0] == 1);
}

TEST_CASE("a state of another size is a mistake of the program, and the file goes on") {
    const TemporaryFolder folder;
    const auto writer = make_trajectory_writer("h5md", sample(0), {.path = folder / "a.h5md"});
    CHECK_THROWS_AS(writer->write(State(4, Box(Vec3(4.0, 4.0, 4.0)))), ContractViolation);
    CHECK_THROWS_AS(writer->write(State(3)), ContractViolation);
    writer->write(sample(0));
    writer->close();
    writer->close();
    CHECK_THROWS_AS(writer->write(sample(0)), ContractViolation);
    CHECK(Reader(folder / "a.h5md").shape(group + "position/value")[0] == 1);
}

TEST_CASE("an H5MD file that cannot be created is an error that names it and the cause") {
    const TemporaryFolder folder;
    const auto make = [](const std::filesystem::path& path) {
        return make_trajectory_writer("h5md", sample(0), {.path = path});
    };
    const auto missing = folder / "no/a.h5md";
    CHECK_THROWS_AS(make(missing), FileError);
    CHECK_THROWS_WITH(make(missing), Contains(missing.string()) && Contains("No such file or directory"));
    CHECK_THROWS_AS(make(folder / ""), FileError);
    CHECK_THROWS_WITH(make("/dev/full"), Contains("'/dev/full'"));
}

TEST_CASE("a full disk is an error at any moment, and every frame before it can be read") {
    // HDF5 crashes when it closes a file that it could not write: nothing here may end the process, now or at exit.
    const TemporaryFolder folder;
    const auto path = folder / "a.h5md";
    std::size_t largest = 0;
    for (rlim_t bytes = 50; bytes < 40000; bytes += 997) {
        const FileSizeLimit limit(bytes);
        std::size_t frames = 0;
        std::unique_ptr<TrajectoryWriter> writer;
        try {
            writer = make_trajectory_writer("h5md", sample(0), {.path = path, .velocities = true});
            for (Index step = 0; step < 1000; ++step) {
                writer->write(sample(step));
                ++frames;
            }
            FAIL("the limit has no effect");
        } catch (const FileError& error) {
            REQUIRE_THAT(error.what(), Contains("File too large") && Contains(path.string()));
        }
        if (writer) {
            REQUIRE_THROWS_AS(writer->write(sample(0)), FileError);
            REQUIRE_THROWS_AS(writer->close(), FileError);
            std::filesystem::copy_file(path, folder / "copy.h5md", std::filesystem::copy_options::overwrite_existing);
            const Reader copy(folder / "copy.h5md", H5F_ACC_RDONLY | H5F_ACC_SWMR_READ);
            REQUIRE(copy.shape(group + "position/value")[0] == frames);
            if (frames > 0) {
                const auto last = frames - 1;
                REQUIRE(copy.frame(group + "position/value", last) == expected_positions(static_cast<Index>(last)));
            }
        }
        largest = std::max(largest, frames);
        std::filesystem::remove(path);
    }
    CHECK(largest > 10);  // the limits did reach beyond the creation of the file
}

TEST_CASE("a file that a full disk has cut short is continued in the same process, when there is room again") {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5md";
    CommittedFrames committed;
    {
        const auto writer = make_trajectory_writer("h5md", sample(0), {.path = path});
        writer->write(sample(0));
        writer->write(sample(1));
        committed = writer->commit();
        const FileSizeLimit limit(static_cast<rlim_t>(committed.bytes));
        CHECK_THROWS_AS(
            [&] {
                for (Index step = 2; step < 1000; ++step) {
                    writer->write(sample(step));
                }
            }(),
            FileError);
    }
    {
        const auto writer = make_trajectory_writer("h5md", sample(0), {.path = path, .kept = committed});
        writer->write(sample(2));
        writer->close();
    }
    const Reader reader(path);
    CHECK(reader.shape(group + "position/value")[0] == 3);
    CHECK(reader.frame(group + "position/value", 2) == expected_positions(2));
}

TEST_CASE("HDF5 prints errors for others as before") {
    H5E_auto2_t before = nullptr;
    H5E_auto2_t after = nullptr;
    void* data = nullptr;
    H5Eget_auto2(H5E_DEFAULT, &before, &data);
    const TemporaryFolder folder;
    write_frames({.path = folder / "a.h5md"}, 1);
    H5Eget_auto2(H5E_DEFAULT, &after, &data);
    CHECK(before != nullptr);
    CHECK(before == after);
}
