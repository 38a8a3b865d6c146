#include "io/formats/h5md_reader.hpp"

#include <cmath>
#include "catch.hpp"

#include "io/formats/trajectory_writer.hpp"
#include "io/hdf5/hdf5_output.hpp"
#include "io/output_fixtures.hpp"
#include "io/written_file.hpp"

// Files by h5py and MDAnalysis, with increments instead of arrays, are read by tests/cli/trajectories.py.

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

constexpr int frames = 3;
constexpr int atoms = 2;

SubstanceUnits argon() {
    return {3.405e-10, 1.654e-21, 6.6335e-26};
}

Vec3 place(int frame, int atom) {
    return {0.5 + frame, 1.0 + atom, 2.0 - 3.0 * frame};
}

/// A foreign file of three frames of two atoms. Each member is one way in which it can be another one.
struct Foreign {
    std::string group = "all";
    std::string second_group = {};
    std::vector<std::string> boundary{"periodic", "periodic", "periodic"};
    std::vector<hsize_t> edges_entry{3};  ///< of each frame; none: fixed
    double tilt = 0.0;
    bool image = false;
    bool velocity = false;
    std::vector<std::int64_t> ids = {};      ///< fixed
    std::vector<std::int64_t> all_ids = {};  ///< of each frame, one behind the other
    std::vector<std::int64_t> species = {};
    std::vector<std::int64_t> all_species = {};  ///< of each frame, one behind the other
    std::vector<double> masses = {};
    std::vector<std::string> units = {};  ///< of positions, times, velocities
    std::int64_t first_step = 0;
    std::int64_t velocity_steps_later = 0;
    int velocity_frames = frames;
    int velocity_steps = frames;
    double first_coordinate = place(0, 0)[0];
    bool killed = false;  ///< as a kill leaves the file

    void write(const std::filesystem::path& path) const {
        Hdf5Output output(path);
        output.create_group("particles");
        if (!second_group.empty()) {
            output.create_group("particles/" + second_group);
        }
        const std::string all = "particles/" + group;
        output.create_group(all);
        output.create_group(all + "/box");
        output.set_fixed_texts(all + "/box", "boundary", boundary);
        for (const char* name : {"/position", "/image", "/velocity", "/box/edges", "/id", "/species"}) {
            const bool wanted = (name != std::string("/image") || image) &&
                                (name != std::string("/velocity") || velocity) &&
                                (name != std::string("/box/edges") || !edges_entry.empty()) &&
                                (name != std::string("/id") || !all_ids.empty()) &&
                                (name != std::string("/species") || !all_species.empty());
            if (wanted) {
                output.create_group(all + name);
            }
        }
        if (edges_entry.empty()) {
            output.write_numbers(all + "/box/edges", std::vector<double>{4, 5, 6});
        }
        if (!ids.empty()) {
            output.write_numbers(all + "/id", ids);
        }
        if (!species.empty()) {
            output.write_numbers(all + "/species", species);
        }
        if (!masses.empty()) {
            output.write_numbers(all + "/mass", masses);
        }
        append_all(output, all);
        output.commit();
        const std::filesystem::path open_copy = path.string() + ".open";
        std::filesystem::copy_file(path, open_copy);
        output.close();
        if (killed) {
            std::filesystem::rename(open_copy, path);
        }
    }

  private:
    void append_all(Hdf5Output& output, const std::string& all) const {
        const std::vector<hsize_t> vectors{atoms, 3};
        Hdf5Output::Series step{all + "/position/step", {}, H5T_NATIVE_INT64};
        Hdf5Output::Series time{all + "/position/time", {}, H5T_NATIVE_DOUBLE};
        Hdf5Output::Series position{all + "/position/value", vectors, H5T_NATIVE_DOUBLE};
        Hdf5Output::Series images{all + "/image/value", vectors, H5T_NATIVE_INT64};
        Hdf5Output::Series velocities{all + "/velocity/value", vectors, H5T_NATIVE_DOUBLE};
        Hdf5Output::Series velocity_step{all + "/velocity/step", {}, H5T_NATIVE_INT64};
        Hdf5Output::Series edges{all + "/box/edges/value", edges_entry, H5T_NATIVE_DOUBLE};
        Hdf5Output::Series id{all + "/id/value", {atoms}, H5T_NATIVE_INT64};
        Hdf5Output::Series kinds{all + "/species/value", {atoms}, H5T_NATIVE_INT64};
        const auto create = [&](Hdf5Output::Series& series) {
            std::vector<hsize_t> chunk{1};
            chunk.insert(chunk.end(), series.entry.begin(), series.entry.end());
            output.create_series(series, chunk);
        };
        create(step);
        create(time);
        create(position);
        if (image) create(images);
        if (velocity) create(velocities);
        if (velocity) create(velocity_step);
        if (!edges_entry.empty()) create(edges);
        if (!all_ids.empty()) create(id);
        if (!all_species.empty()) create(kinds);
        if (!units.empty()) {
            output.set_variable_text(position.name, "unit", units[0]);
            if (units.size() > 1) output.set_variable_text(time.name, "unit", units[1]);
            if (velocity && units.size() > 2) output.set_variable_text(velocities.name, "unit", units[2]);
        }
        output.start_appending();
        for (int f = 0; f < frames; ++f) {
            const std::int64_t this_step = first_step + 10 * f;
            const std::int64_t later = this_step + velocity_steps_later;
            const double this_time = 0.25 * f;
            std::vector<double> r;
            std::vector<double> v;
            std::vector<std::int64_t> n;
            for (int k = 0; k < atoms; ++k) {
                for (int axis = 0; axis < 3; ++axis) {
                    r.push_back(place(f, k)[axis]);
                    v.push_back(k + 0.5 * axis);
                    n.push_back(axis - k);
                }
            }
            if (f == 0) r[0] = first_coordinate;
            output.append(step, &this_step);
            output.append(time, &this_time);
            output.append(position, r.data());
            if (image) output.append(images, n.data());
            if (velocity && f < velocity_frames) output.append(velocities, v.data());
            if (velocity && f < velocity_steps) output.append(velocity_step, &later);
            const std::vector<double> e = edges_entry.size() == 1 ? std::vector<double>{4, 5, 6}
                                                                  : std::vector<double>{4, tilt, 0, 0, 5, 0, 0, 0, 6};
            if (!edges_entry.empty()) output.append(edges, e.data());
            const auto first = static_cast<std::size_t>(atoms * f);
            if (first < all_ids.size()) output.append(id, &all_ids[first]);
            if (!all_species.empty()) output.append(kinds, &all_species[first]);
        }
        for (std::size_t more = atoms * frames; more < all_species.size(); more += atoms) {
            output.append(kinds, &all_species[more]);
        }
    }
};

struct Read {
    std::vector<Frame> frames;
    std::string warning;
    std::string unused_velocities;
};

Read read_all(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units = std::nullopt,
              const std::string& group = {}) {
    H5mdReader reader(path, units, group);
    Read all;
    Frame frame;
    while (reader.next(frame)) {
        all.frames.push_back(frame);
    }
    all.warning = reader.warnings().empty() ? "" : reader.warnings()[0];
    all.unused_velocities = reader.unused_velocities();
    return all;
}

Read read(const Foreign& foreign, const std::optional<SubstanceUnits>& units = std::nullopt,
          const std::string& group = {}) {
    const TemporaryFolder folder;
    foreign.write(folder / "a.h5");
    return read_all(folder / "a.h5", units, group);
}

std::string complaint(const Foreign& foreign, const std::optional<SubstanceUnits>& units = std::nullopt,
                      const std::string& group = {}) {
    return data_error([&] { static_cast<void>(read(foreign, units, group)); });
}

}  // namespace

TEST_CASE("boxes of foreign H5MD files are fixed or not, vectors or matrices") {
    for (const Foreign& foreign : {Foreign{}, Foreign{.edges_entry = {3, 3}}, Foreign{.edges_entry = {}},
                                   Foreign{.group = "trajectory", .second_group = "another"}}) {
        const Read all = read(foreign);
        REQUIRE(all.frames.size() == frames);
        CHECK(all.warning.empty());
        for (int f = 0; f < frames; ++f) {
            const Frame& frame = all.frames[static_cast<std::size_t>(f)];
            CHECK(frame.configuration.edges == Vec3(4, 5, 6));
            CHECK(frame.configuration.positions == std::vector<Vec3>{place(f, 0), place(f, 1)});
            CHECK(frame.configuration.velocities.empty());
            CHECK(frame.configuration.step == 10 * f);
            CHECK(frame.configuration.time == 0.25 * f);
            CHECK((frame.configuration.step && frame.configuration.time));
            CHECK_FALSE(frame.configuration.is_unwrapped);
        }
    }
}

TEST_CASE("images of an H5MD file are applied, velocities read") {
    const Read all = read({.image = true, .velocity = true});
    const Frame& last = all.frames.at(2);
    CHECK(last.configuration.is_unwrapped);
    CHECK(last.configuration.positions[0] == place(2, 0) + Vec3(0, 5, 12));
    CHECK(last.configuration.positions[1] == place(2, 1) + Vec3(-4, 0, 6));
    CHECK(last.configuration.velocities == std::vector<Vec3>{{0, 0.5, 1}, {1, 1.5, 2}});
}

TEST_CASE("atoms of an H5MD file are sorted by id, which may be others in each frame") {
    CHECK(read({.ids = {9, 4}}).frames.at(1).configuration.positions == std::vector<Vec3>{place(1, 1), place(1, 0)});
    const Read all = read({.velocity = true, .all_ids = {1, 2, 2, 1, 1, 2}});
    CHECK(all.frames.at(0).configuration.positions[0] == place(0, 0));
    CHECK(all.frames.at(1).configuration.positions[0] == place(1, 1));
    CHECK(all.frames.at(1).configuration.velocities[0] == Vec3(1, 1.5, 2));
    CHECK(all.frames.at(2).configuration.positions[0] == place(2, 0));
}

TEST_CASE("units of an H5MD file are converted") {
    const SubstanceUnits units = argon();
    for (const auto& [names, length, time] :
         {std::tuple(std::vector<std::string>{"nm", "ps", "nm ps-1"}, 1e-9, 1e-12),
          std::tuple(std::vector<std::string>{"Angstrom", "fs", "Angstrom fs-1"}, 1e-10, 1e-15),
          std::tuple(std::vector<std::string>{"A", "ns", "A/ns"}, 1e-10, 1e-9)}) {
        CAPTURE(names);
        const Configuration found = read({.velocity = true, .units = names}, units).frames.at(2).configuration;
        const double sigma = units.si(Dimension::length) / length;
        const double tau = units.si(Dimension::time) / time;
        CHECK((found.positions[1] - place(2, 1) / sigma).norm() < 1e-12 / sigma);
        CHECK(found.edges[2] == Approx(6.0 / sigma).epsilon(1e-14));
        CHECK(found.time == Approx(0.5 / tau).epsilon(1e-14));
        CHECK(found.velocities[1][0] == Approx(tau / sigma).epsilon(1e-14));
    }
}

TEST_CASE("what ljmd writes is read back to the last bit, closed or not") {
    const TemporaryFolder folder;
    State state(2, Box(Vec3(4, 5, 6)));
    state.write_positions().col(0) = state.snapped(Vec3(1.1, 2.2, 3.3));
    state.write_velocities().col(1) = Vec3(0.1, 0.2, 0.3);
    state.set_image(0, Eigen::Vector3i(3, -2, 0));
    const auto writer = make_trajectory_writer("h5md", state, {.path = folder / "a.h5md", .velocities = true});
    writer->write(state);
    state.step = 5;
    state.time = 0.02;
    writer->write(state);
    std::filesystem::copy_file(folder / "a.h5md", folder / "open.h5md");
    writer->close();
    for (const char* name : {"a.h5md", "open.h5md"}) {
        const Read all = read_all(folder / name);
        REQUIRE(all.frames.size() == 2);
        const Frame& last = all.frames[1];
        CHECK(last.configuration.positions == std::vector<Vec3>{state.unwrapped(0), state.unwrapped(1)});
        CHECK(last.configuration.velocities[1] == Vec3(0.1, 0.2, 0.3));
        CHECK(last.configuration.step == 5);
        CHECK(last.configuration.time == 0.02);
        CHECK(last.configuration.is_unwrapped);
        CHECK(all.warning.empty() == (name == std::string("a.h5md")));
    }
}

TEST_CASE("of an H5MD file whose writer was killed the whole frames are read, with a warning") {
    const Read open = read({.killed = true});
    CHECK(open.frames.size() == frames);
    CHECK_THAT(open.warning, Contains("was not closed"));
    const Read short_one = read({.all_ids = {1, 2, 1, 2}});
    CHECK(short_one.frames.size() == 2);
    CHECK_THAT(short_one.warning, Contains("some arrays have 3 frames, others 2; the first 2 are used"));
}

TEST_CASE("velocities of an H5MD file at other steps than the positions are left out, the positions are not") {
    for (const Foreign& foreign : {Foreign{.velocity = true, .velocity_steps_later = 1},
                                   Foreign{.velocity = true, .velocity_frames = 1, .velocity_steps = 1},
                                   Foreign{.velocity = true, .velocity_frames = 0, .velocity_steps = 0}}) {
        const Read all = read(foreign);
        REQUIRE(all.frames.size() == frames);
        CHECK(all.frames[1].configuration.velocities.empty());
        CHECK(all.frames[1].configuration.positions[0] == place(1, 0));
        CHECK(all.unused_velocities == "at other steps than the positions");
        CHECK(all.warning.empty());
    }
    const Read killed = read({.velocity = true, .velocity_frames = 2, .velocity_steps = 2, .killed = true});
    CHECK(killed.frames.size() == 2);
    CHECK(killed.frames[1].configuration.velocities.size() == atoms);
    CHECK(killed.unused_velocities.empty());
}

TEST_CASE("atoms of an H5MD file are of one kind, fixed and in time") {
    CHECK_THAT(complaint({.species = {0, 1}}),
               Contains("particles/all: species '1' beside '0', but ljmd has one kind of atom"));
    CHECK_THAT(complaint({.all_species = {3, 3, 3, 3, 3, 4}}), Contains("species '4' beside '3'"));
    CHECK_THAT(complaint({.masses = {1.0, 2.0}}), Contains("mass '2' beside '1'"));
    const Read all = read({.all_species = {3, 3, 3, 3, 3, 3}, .masses = {1.5, 1.5}});
    CHECK(all.frames.at(2).configuration.masses == std::vector<double>{1.5, 1.5});
    CHECK(read({.velocity = true, .masses = {39.9, 39.9}, .units = {"nm", "ps", "nm ps-1"}}, argon())
              .frames.at(0)
              .configuration.masses.empty());
}

TEST_CASE(
    "arrays of other atoms than the positions are refused before they are read, entries without a frame are not") {
    CHECK_THAT(complaint({.species = {0, 0, 0}}), Contains("species is of 3 atoms, the positions are of 2"));
    CHECK_THAT(complaint({.masses = {1, 1, 1}}), Contains("mass is of 3 atoms, the positions are of 2"));
    CHECK_THAT(complaint({.ids = {1, 2, 3}}), Contains("id is of 3 atoms, the positions are of 2"));
    CHECK(read({.species = {7}}).frames.size() == frames);
    CHECK(read({.all_species = {3, 3, 3, 3, 3, 3, 4, 4}}).frames.size() == frames);
}

TEST_CASE("species and velocities as other programs write them") {
    // By h5py: an enumeration of argon and krypton, all argon; two species in time; velocities at the second of two
    // steps.
    const std::string data = LJMD_TEST_DATA "/h5md/";
    CHECK(read_all(data + "species_enum.h5md").frames.size() == 2);
    CHECK_THAT(data_error([&] { static_cast<void>(read_all(data + "species_in_time.h5md")); }),
               Contains("species '1' beside '0', but ljmd has one kind of atom"));
    const Read all = read_all(data + "velocity_at_other_steps.h5md");
    CHECK(all.frames.size() == 2);
    CHECK(all.unused_velocities == "at other steps than the positions");
}

TEST_CASE("of several groups of particles in an H5MD file one is chosen") {
    const Foreign two{.second_group = "another"};
    CHECK_THAT(complaint(two), Contains("'particles' has 2 groups, all, another: choose one (analyze: --group NAME)"));
    CHECK_THAT(complaint(two, std::nullopt, "some"), Contains("'particles' has no group 'some', but all, another"));
    CHECK_THAT(complaint(two, std::nullopt, "another"), Contains("no positions that change with time"));
    CHECK(read(two, std::nullopt, "all").frames.at(1).configuration.positions[0] == place(1, 0));
    CHECK(read({}, std::nullopt, "all").frames.size() == frames);
    CHECK_THAT(complaint({}, std::nullopt, "some"), Contains("no group 'some', but all"));
}

TEST_CASE("H5MD files that cannot be used are refused, with the reason") {
    CHECK_THAT(complaint({.boundary = {"periodic", "none", "periodic"}}), Contains("must be periodic"));
    CHECK_THAT(complaint({.edges_entry = {3, 3}, .tilt = 0.5}), Contains("frame 1: the box is tilted"));
    CHECK(read({.edges_entry = {3, 3}, .tilt = 1.6e-15}).frames.at(0).configuration.edges == Vec3(4, 5, 6));
    CHECK_THAT(complaint({.edges_entry = {2}}), Contains("neither a vector nor a matrix"));
    CHECK_THAT(complaint({.ids = {3, 3}}), Contains("frame 1: id 3 occurs twice"));
    CHECK_THAT(complaint({.all_ids = {1, 2, 2, 1, 1, 7}}),
               Contains("frame 3: other atoms than in frame 1: id 7, where that has id 2"));
    CHECK_THAT(complaint({.ids = {3, -1}}), Contains("frame 1: id -1: an atom is missing"));
    CHECK_THAT(complaint({.ids = {1}}), Contains("frame 1: 1 ids, but 2 atoms"));
    CHECK_THAT(complaint({.first_step = -10}), Contains("frame 1: the step must be an integer of at least 0"));
    CHECK_THAT(complaint({.first_coordinate = std::nan("")}), Contains("frame 1: atom 1 has a position that is not"));
    CHECK_THAT(complaint({.first_coordinate = 1e8}), Contains("frame 1: atom 1 is more than"));
    CHECK_THAT(complaint({.units = {"nm", "ps"}}), Contains("a deck with [argon] is needed"));
    CHECK_THAT(complaint({.units = {"furlong", "ps"}}, argon()), Contains("no known unit of length"));
    CHECK_THAT(complaint({.units = {"nm"}}, argon()), Contains("position/time has none"));
    CHECK_THAT(complaint({.velocity = true, .units = {"nm", "ps", "nm ps"}}, argon()), Contains("unit of velocity"));
    const TemporaryFolder folder;
    {
        Hdf5Output empty(folder / "a.h5");
        empty.create_group("other");
        empty.close();
    }
    CHECK_THAT(data_error([&] { static_cast<void>(read_all(folder / "a.h5")); }), Contains("not H5MD"));
}
