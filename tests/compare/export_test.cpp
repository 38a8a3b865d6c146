#include "compare/export.hpp"

#include <fstream>
#include <optional>

#include "compare/fluid.hpp"
#include "compare/lammps_input.hpp"
#include "compare/openmm.hpp"
#include "deck/deck_fixtures.hpp"
#include "deck/fluid.hpp"
#include "engine/fluid_system.hpp"
#include "io/formats/configuration_reader.hpp"
#include "io/formats/trajectory_reader.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// The start of the small deck with an atom that has crossed a wall.
State travelled(const Deck& deck) {
    State state = simulation_of(deck).state;
    state.set_image(5, Eigen::Vector3i(1, -2, 0));
    state.step = 12;
    return state;
}

void check_configuration(const fs::path& path, const State& state, bool unwrapped) {
    const Configuration found = read_configuration(path, std::nullopt);
    REQUIRE(found.positions.size() == static_cast<std::size_t>(state.count()));
    CHECK(found.edges == state.box().edges());
    for (Index i = 0; i < state.count(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        CHECK(found.positions[k] == (unwrapped ? state.unwrapped(i) : Vec3(state.positions().col(i))));
        CHECK(found.velocities[k] == state.velocities().col(i));
    }
}

}  // namespace

TEST_CASE("the time step of an export is that of the first sampled stage, or of the last one") {
    const auto stage_of = [](const Replacements& replacements) {
        const DeckFolder folder(changed(small_deck, replacements));
        return exported_stage(folder.load()).name;
    };
    CHECK(stage_of({}) == "production");
    CHECK(stage_of({{"steps = 20", "steps = 20\nsample = true"}}) == "equilibrate");
    CHECK(stage_of({{"sample = true", "sample = false"}}) == "production");
}

TEST_CASE("LAMMPS gets a data file and an input") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const State state = travelled(deck);
    const fs::path directory = folder / "a" / "b";
    const Exported written = export_configuration(deck, state, "lammps", directory);
    CHECK(written.files == std::vector<fs::path>{directory / "start.data", directory / "in.lammps"});
    CHECK_THAT(written.usage, Contains(directory.string()) && Contains("lmp -in in.lammps"));
    CHECK(written.warnings.empty());
    check_configuration(directory / "start.data", state, false);
    const Fluid fluid = fluid_of(state, pair_potential_of(deck.potential()), false);
    CHECK(content_of(directory / "in.lammps") == lammps_user_input(fluid, 0.004, 40, "A small liquid"));
    CHECK(std::distance(fs::directory_iterator(directory), fs::directory_iterator()) == 2);
}

TEST_CASE("extended XYZ and H5MD hold the configuration with its velocities") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const State state = travelled(deck);
    CHECK(export_configuration(deck, state, "extxyz", folder / "xyz").files ==
          std::vector<fs::path>{folder / "xyz" / "start.xyz"});
    check_configuration(folder / "xyz" / "start.xyz", state, true);

    const fs::path directory = folder / "h5md";
    CHECK(export_configuration(deck, state, "h5md", directory).files ==
          std::vector<fs::path>{directory / "start.h5md"});
    CHECK(content_of(directory / "start.h5md").starts_with("\x89HDF\r\n"));
    CHECK(std::distance(fs::directory_iterator(directory), fs::directory_iterator()) == 1);
}

TEST_CASE("forces are exported on request, where the format has them") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const State state = travelled(deck);
    static_cast<void>(export_configuration(deck, state, "extxyz", folder / "xyz", true));
    check_configuration(folder / "xyz" / "start.xyz", state, true);
    CHECK_THAT(content_of(folder / "xyz" / "start.xyz"), Contains(":forces:R:3:id:I:1"));
    static_cast<void>(export_configuration(deck, state, "h5md", folder / "h5md", true));
    const auto reader = open_trajectory(folder / "h5md" / "start.h5md", std::nullopt);
    Frame frame;
    REQUIRE(reader->next(frame));
    State same = state;
    make_force_field(fluid_spec(deck), same.execution()).evaluate(same, Request::forces);
    REQUIRE(frame.forces.size() == static_cast<std::size_t>(state.count()));
    for (Index i = 0; i < same.count(); ++i) {
        CHECK(frame.forces[static_cast<std::size_t>(same.ids()[static_cast<std::size_t>(i)])] == same.forces().col(i));
    }
    CHECK_THROWS_WITH(export_configuration(deck, state, "lammps", folder / "lammps", true),
                      Contains("--forces: lammps computes them itself"));
    CHECK_FALSE(fs::exists(folder / "lammps"));
}

TEST_CASE("OpenMM gets its XML, from a build that has it") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const State state = travelled(deck);
    if (!openmm_is_built_in()) {
        CHECK_THROWS_AS(export_configuration(deck, state, "openmm", folder / "openmm"), InputError);
        CHECK_FALSE(fs::exists(folder / "openmm"));
        return;
    }
    const OpenmmXml xml = openmm_xml(fluid_of(state, pair_potential_of(deck.potential()), false), 0.004);
    const Exported written = export_configuration(deck, state, "openmm", folder / "openmm");
    REQUIRE(written.files.size() == 3);
    CHECK(content_of(written.files[0]) == xml.system);
    CHECK(content_of(written.files[1]) == xml.state);
    CHECK(content_of(written.files[2]) == xml.integrator);
}

TEST_CASE("what an export leaves out of a deck is told") {
    const std::string held =
        "steps = 40\nthermostat = { type = \"langevin\", time = 1.0 }\n"
        "barostat = { type = \"stochastic-cell-rescaling\", pressure = 0.5, compressibility = 0.1, "
        "time = 1.0 }";
    const DeckFolder folder(changed(small_deck, {{"steps = 40", held}}));
    const Deck deck = folder.load();
    State start = simulation_of(deck).state;
    REQUIRE(start.step == 0);
    const auto words = export_configuration(deck, start, "lammps", folder / "start").warnings;
    REQUIRE(words.size() == 3);
    CHECK_THAT(words[0], Contains("left out: stage 'equilibrate'; the motion exported is that of 'production'"));
    CHECK_THAT(words[1], Contains("thermostat 'langevin' of stage 'production'") && Contains("constant energy"));
    CHECK_THAT(words[2], Contains("barostat 'stochastic-cell-rescaling'") && Contains("constant volume"));
    start.step = 60;  // the first stage is past
    CHECK(export_configuration(deck, start, "lammps", folder / "end").warnings.size() == 2);

    const DeckFolder leapfrog(changed(small_deck, {{"steps = 40", "steps = 40\nintegrator = \"leapfrog\""}}));
    const Deck other = leapfrog.load();
    const auto moved = export_configuration(other, travelled(other), "lammps", leapfrog / "end").warnings;
    REQUIRE(moved.size() == 1);
    CHECK_THAT(moved[0], Contains("'leapfrog'") && Contains("velocity Verlet"));
    CHECK(export_configuration(other, travelled(other), "extxyz", leapfrog / "xyz").warnings.empty());
}

TEST_CASE("a tail that LAMMPS does not have is warned of") {
    const DeckFolder folder(
        changed(small_deck, {{"\"force-shifted\"", "\"switched\"\nswitch_start = 1.75\ntail = true"}}));
    const Deck deck = folder.load();
    const Exported written = export_configuration(deck, travelled(deck), "lammps", folder / "lammps");
    REQUIRE(written.warnings.size() == 1);
    CHECK_THAT(written.warnings[0], Contains("no tail corrections for 'lennard-jones' with truncation 'switched'"));
    const DeckFolder plain(changed(small_deck, {{"\"force-shifted\"", "\"cut\"\ntail = true"}}));
    const Deck cut = plain.load();
    CHECK(export_configuration(cut, travelled(cut), "lammps", plain / "lammps").warnings.empty());
    CHECK_THAT(content_of(plain / "lammps" / "in.lammps"), Contains("pair_modify tail yes"));
}

TEST_CASE("a potential that LAMMPS does not have leaves nothing behind") {
    const DeckFolder folder(
        changed(small_deck, {{"\"lennard-jones\"", "\"morse\"\nwell_depth = 1.0\nsteepness = 6.0\nminimum = 1.12"},
                             {"\"force-shifted\"", "\"switched\"\nswitch_start = 1.75\ntail = false"}}));
    const Deck deck = folder.load();
    CHECK_THROWS_AS(export_configuration(deck, travelled(deck), "lammps", folder / "lammps"), InputError);
    CHECK_FALSE(fs::exists(folder / "lammps"));
    CHECK_NOTHROW(export_configuration(deck, travelled(deck), "extxyz", folder / "xyz"));
}

TEST_CASE("what would be replaced, and what is unknown, is refused") {
    const TemporaryFolder folder;
    CHECK(export_targets() == std::vector<std::string>{"lammps", "openmm", "extxyz", "h5md"});
    CHECK_THROWS_AS(check_export("gromacs", folder / "x", false), InputError);
    CHECK_THROWS_WITH(check_export("gromacs", folder / "x", true),
                      "unknown target 'gromacs' to export to, allowed: 'lammps', 'openmm', 'extxyz', 'h5md'");
    CHECK_NOTHROW(check_export("lammps", folder / "x", false));
    fs::create_directory(folder / "x");
    std::ofstream(folder / "x" / "start.xyz") << "mine";
    CHECK_NOTHROW(check_export("lammps", folder / "x", false));
    CHECK_THROWS_AS(check_export("extxyz", folder / "x", false), InputError);
    CHECK_THROWS_WITH(check_export("extxyz", folder / "x", false),
                      Contains("start.xyz is there already") && Contains("or replace it"));
    CHECK_NOTHROW(check_export("extxyz", folder / "x", true));
    CHECK_THROWS_WITH(check_export("extxyz", folder / "x" / "start.xyz", true), Contains("is not a directory"));
}

TEST_CASE("a file that cannot be written is an error, and half of it does not stay") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const State state = travelled(deck);
    for (const char* target : {"lammps", "extxyz", "h5md"}) {
        INFO(target);
        const fs::path directory = folder / target;
        fs::create_directory(directory);
        {
            const FileSizeLimit limit(1000);
            CHECK_THROWS_AS(export_configuration(deck, state, target, directory), FileError);
        }
        CHECK(fs::is_empty(directory));
    }
}
