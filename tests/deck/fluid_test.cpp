#include "deck/fluid.hpp"

#include <cmath>

#include "deck/deck_fixtures.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/model/lattice.hpp"
#include "model/velocities.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string lattice = "lattice = { type = \"fcc\", cells = 3 }";

/// A deck that starts from start.xyz in its folder. What is said of density and temperature is up to the test.
class FileStart {
  public:
    explicit FileStart(const std::string& system = "")
        : folder_(changed(small_deck, {{lattice, system},
                                       {"density = 0.8\ntemperature = 1.0\n", ""},
                                       {"thermostat =", "temperature = 1.0\nthermostat ="}})) {}

    /// Eight atoms in a box of 4 x 4.5 x 5 with velocities whose mean is the drift; some are outside the box.
    void write(const Vec3& drift, bool velocities = true) const {
        State state(8, Box(Vec3(4.0, 4.5, 5.0)));
        for (Index i = 0; i < 8; ++i) {
            const Vec3 corner(static_cast<double>(i % 2), static_cast<double>(i / 2 % 2), static_cast<double>(i / 4));
            state.write_positions().col(i) =
                state.snapped(Vec3(0.3 + 2.0 * corner[0], 0.2 + 2.25 * corner[1], 2.5 * corner[2]));
            state.set_image(i, Eigen::Vector3i(i == 3 ? 2 : 0, 0, i == 5 ? -1 : 0));
            state.write_velocities().col(i) = drift + (i % 2 == 0 ? 1.0 : -1.0) * Vec3(0.5, 0.25 * corner[1], -0.125);
        }
        write_configuration(path(), state, velocities);
    }

    [[nodiscard]] std::filesystem::path path() const { return folder_ / "start.xyz"; }

    /// The deck as if its [system] said so.
    [[nodiscard]] Deck load(std::vector<std::string> settings = {}) const {
        settings.insert(settings.begin(), "system.file=" + path().string());
        return folder_.load(settings);
    }

  private:
    DeckFolder folder_;
};

std::vector<double> all_bits(const State& state) {
    std::vector<double> numbers;
    for (Index i = 0; i < state.count(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            numbers.push_back(state.positions()(axis, i));
            numbers.push_back(state.velocities()(axis, i));
        }
    }
    return numbers;
}

std::vector<double> start_bits(const std::string& start, const std::string& seed) {
    const DeckFolder folder(changed(small_deck, {{lattice, start}, {"seed = 7", "seed = " + seed}}));
    return all_bits(simulation_of(folder.load()).state);
}

}  // namespace

TEST_CASE("a lattice start has the atoms and the density that were asked for") {
    struct Case {
        std::string start;
        Index atoms;
    };
    for (const Case& c :
         {Case{"type = \"fcc\", cells = 3", 108}, Case{"type = \"fcc\", atoms = 256", 256},
          Case{"type = \"simple-cubic\", cells = 5", 125}, Case{"type = \"simple-cubic\", atoms = 216", 216},
          Case{"type = \"random\", atoms = 77", 77}}) {
        INFO(c.start);
        const DeckFolder folder(changed(small_deck, {{lattice, "lattice = { " + c.start + " }"}}));
        const Start start = find_start(folder.load());
        CHECK(start.atoms == c.atoms);
        CHECK(static_cast<double>(start.atoms) / start.box.volume() == Approx(0.8).epsilon(1e-14));
        CHECK(start.box.shortest_edge() == start.box.edges().maxCoeff());
        CHECK_FALSE(start.configuration.has_value());
    }
}

TEST_CASE("a crystal stands on its lattice, at the temperature, without momentum") {
    for (const char* type : {"fcc", "simple-cubic"}) {
        const DeckFolder folder(
            changed(small_deck, {{"\"fcc\", cells = 3", std::string("\"") + type + "\", cells = 5"}}));
        const FluidSystem simulation = simulation_of(folder.load());
        const State& state = simulation.state;
        const auto sites =
            lattice_sites(std::string(type) == "fcc" ? Lattice::fcc : Lattice::simple_cubic, 5, state.box());
        for (Index i = 0; i < state.count(); ++i) {
            REQUIRE(state.positions().col(i) == sites[static_cast<std::size_t>(i)]);
        }
        REQUIRE(simulation.order.has_value());
        CHECK((*simulation.order)(state) == Approx(1.0).epsilon(1e-12));
        CHECK(temperature(state).value() == Approx(1.0).epsilon(1e-13));
        CHECK(total_momentum(state).norm() < 1e-12);
        CHECK(state.step == 0);
        CHECK(state.time == 0.0);
        CHECK(simulation.relaxation_iterations == 0);
    }
}

TEST_CASE("a random start is relaxed until no atoms overlap") {
    const DeckFolder folder(changed(small_deck, {{lattice, "lattice = { type = \"random\", atoms = 108 }"}}));
    const FluidSystem simulation = simulation_of(folder.load());
    const State& state = simulation.state;
    CHECK(simulation.relaxation_iterations > 0);
    CHECK_FALSE(simulation.order.has_value());
    double nearest = 1e300;
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = 0; j < i; ++j) {
            nearest = std::min(nearest,
                               state.box().minimum_image(state.positions().col(i) - state.positions().col(j)).norm());
        }
    }
    CHECK(nearest > 0.8);
    CHECK(temperature(state).value() == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("the seed decides every bit of a start") {
    for (const char* start :
         {"lattice = { type = \"fcc\", cells = 3 }", "lattice = { type = \"random\", atoms = 60 }"}) {
        INFO(start);
        CHECK(start_bits(start, "3") == start_bits(start, "3"));
        CHECK(start_bits(start, "3") != start_bits(start, "4"));
    }
}

TEST_CASE("tail and analyses are there when the deck asks for them") {
    const DeckFolder plain;
    const FluidSystem without = simulation_of(plain.load());
    CHECK(without.tail.energy(0.8) == 0.0);
    CHECK(without.analyses.empty());
    const DeckFolder full(changed(small_deck, {{"\"force-shifted\"", "\"cut\"\ntail = true"}}) +
                          "[analysis]\nrdf = {}\n");
    const Deck deck = full.load();
    CHECK(simulation_of(deck).tail.energy(0.8) < 0.0);
    CHECK(simulation_of(deck).analyses.size() == 1);
    CHECK(simulation_of(full.load({"potential.tail=false"})).tail.energy(0.8) == 0.0);
}

TEST_CASE("a start from a file keeps atoms, box and velocities, atoms outside the box with their images") {
    const FileStart start;
    start.write(Vec3::Zero());
    const Deck deck = start.load({"potential.cutoff=1.5"});
    const Start found = find_start(deck);
    REQUIRE(found.configuration.has_value());
    CHECK(found.box.edges() == Vec3(4.0, 4.5, 5.0));
    const FluidSystem simulation = make_fluid(fluid_spec(deck, found), Execution(), no_warnings);
    const State& state = simulation.state;
    CHECK_FALSE(simulation.order.has_value());
    const std::vector<Index> index = state.index_of();
    for (Index id = 0; id < 8; ++id) {
        const Index i = index[static_cast<std::size_t>(id)];
        const auto k = static_cast<std::size_t>(id);
        CHECK((state.unwrapped(i) - found.configuration->positions[k]).norm() < 1e-14);
        CHECK(state.velocities().col(i) == found.configuration->velocities[k]);
        CHECK((state.positions().col(i).array() >= 0.0).all());
        CHECK((state.positions().col(i).array() < state.box().edges().array()).all());
    }
    CHECK(state.image(index[3]) == Eigen::Vector3i(2, 0, 0));
}

TEST_CASE("the directory of a run stands for its last configuration") {
    const TemporaryFolder folder;
    CHECK(configuration_file((folder / "").string()) == folder / "" / "final.xyz");
    CHECK(configuration_file("start.xyz") == "start.xyz");
    const FileStart start;
    start.write(Vec3::Zero());
    const Deck deck = start.load();
    CHECK_THROWS_AS(find_start(start.load({"system.file=" + (folder / "none").string()})), DataError);
}

TEST_CASE("a density scales a file's box and positions, and leaves its velocities") {
    const FileStart start;
    start.write(Vec3::Zero());
    const Deck deck = start.load({"system.density=0.04"});
    const Start found = find_start(deck);
    CHECK(8.0 / found.box.volume() == Approx(0.04).epsilon(1e-14));
    const double factor = std::cbrt(8.0 / 0.04 / 90.0);
    CHECK((found.box.edges() - factor * Vec3(4.0, 4.5, 5.0)).norm() < 1e-13);
    const Start as_written = find_start(start.load());
    for (std::size_t k = 0; k < 8; ++k) {
        CHECK((found.configuration->positions[k] - factor * as_written.configuration->positions[k]).norm() < 1e-13);
        CHECK(found.configuration->velocities[k] == as_written.configuration->velocities[k]);
    }
}

TEST_CASE("a moving centre of mass is stopped, and the user told") {
    const FileStart start;
    start.write(Vec3(0.0, 0.0, 0.25));
    const Deck deck = start.load();
    std::vector<std::string> warnings;
    const FluidSystem simulation = make_fluid(fluid_spec(deck, find_start(deck)), Execution(),
                                              [&](const std::string& text) { warnings.push_back(text); });
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains("0.25 sigma/tau"));
    CHECK(total_momentum(simulation.state).norm() < 1e-14);
}

TEST_CASE("velocities are drawn when the file has none, or when the deck says so") {
    const FileStart start;
    start.write(Vec3::Zero());
    const auto drawn = simulation_of(start.load({"system.velocities=maxwell", "system.temperature=2.5"}));
    CHECK(temperature(drawn.state).value() == Approx(2.5).epsilon(1e-13));
    // a temperature alone is for thermostats: the velocities of the file stay
    const auto kept = simulation_of(start.load({"system.temperature=2.5"}));
    CHECK(temperature(kept.state).value() < 0.5);

    start.write(Vec3::Zero(), false);
    const auto had_none = simulation_of(start.load({"system.temperature=2.5"}));
    CHECK(temperature(had_none.state).value() == Approx(2.5).epsilon(1e-13));
    CHECK(all_bits(had_none.state) == all_bits(drawn.state));
    CHECK_THROWS_WITH(simulation_of(start.load()), Contains("no velocities") && Contains("temperature"));
    CHECK_THROWS_AS(simulation_of(start.load()), DataError);
    CHECK_THROWS_WITH(simulation_of(start.load({"system.velocities=file", "system.temperature=1"})),
                      Contains("no velocities"));
}

TEST_CASE("a configuration that no step can be taken from is refused") {
    const FileStart start;
    start.write(Vec3::Zero());
    const Deck deck = start.load();
    const Start good = find_start(deck);
    const auto refused = [&](const std::function<void(Configuration&)>& spoil, const std::string& message) {
        INFO(message);
        Start bad = good;
        spoil(*bad.configuration);
        CHECK_THROWS_AS(make_fluid(fluid_spec(deck, bad), Execution(), no_warnings), DataError);
        CHECK_THROWS_WITH(make_fluid(fluid_spec(deck, bad), Execution(), no_warnings), Contains(message));
    };
    refused([](Configuration& c) { c.positions[4][1] = 5e6; }, "atom 5 is more than a million edges away");
    refused([](Configuration& c) { c.masses = std::vector<double>(8, 2.0); }, "mass 2");
    CHECK_NOTHROW(make_fluid(fluid_spec(deck, good), Execution(), no_warnings));
}
