// LAMMPS as the judge: the same melted liquid in both programs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include "catch.hpp"

#include "cli/command_words.hpp"
#include "compare/lammps.hpp"
#include "compare/lammps_input.hpp"
#include "compare/peers.hpp"
#include "compare/small_fluid.hpp"
#include "deck/deck_fixtures.hpp"
#include "forces/every_potential.hpp"
#include "io/files/text_file.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "physics/liquid.hpp"
#include "run/recorded_run.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

constexpr double time_step = 0.004;
constexpr Index steps = 100;

// `test_parity -s` shows what is measured.
constexpr double energy_tolerance = 1e-12;      // relative
constexpr double pressure_tolerance = 1e-12;    // relative
constexpr double force_tolerance = 1e-12;       // of the root mean square force
constexpr double trajectory_tolerance = 1e-11;  // [sigma], after 100 steps

/// 864 atoms at density 0.8442 and a temperature of about 0.72.
const State& melt() {
    static const State state = liquid(6, 1967);
    return state;
}

Fluid melt_with(const PairPotential& potential) {
    return fluid_of(melt(), potential, false);
}

std::string name_of(const PairPotential& potential) {
    return potential.formula() + " " + potential.truncation();
}

std::vector<PairPotential> potentials_of_lammps() {
    std::vector<PairPotential> known;
    for (const PairPotential& potential : every_potential()) {
        try {
            static_cast<void>(lammps_pair_style(potential));
            known.push_back(potential);
        } catch (const InputError&) {
            CHECK(potential.formula() != "lennard-jones");
        }
    }
    CHECK(known.size() >= 7);  // all truncations of Lennard-Jones, and those of Morse but one
    return known;
}

/// How far two programs are apart at one moment.
struct Difference {
    double energy;
    double pressure;
    double force;
};

std::string shown(const Difference& difference) {
    return fmt::format("energy {:.1e}, pressure {:.1e}, force {:.1e}", difference.energy, difference.pressure,
                       difference.force);
}

/// Ours by a pair search, theirs as given.
Difference difference_at_start(const Fluid& fluid, const PeerPoint& theirs, const std::string& search) {
    State state = state_of(fluid);
    PairForceField force_field(fluid.potential, make_pair_search(search, 0.3));
    const Evaluation ours = force_field.evaluate(state, Request::forces_and_energy);
    const double three_volumes = 3.0 * state.box().volume();
    const double our_pressure = (2.0 * kinetic_energy(fluid) + ours.virial.trace()) / three_volumes;
    const double their_pressure = (2.0 * theirs.totals.kinetic_energy + theirs.totals.virial) / three_volumes;
    Eigen::Matrix3Xd forces(3, state.count());
    for (Index i = 0; i < state.count(); ++i) {
        forces.col(i) = theirs.forces[static_cast<std::size_t>(i)];
    }
    return {std::abs(theirs.totals.potential_energy / ours.potential_energy - 1.0),
            std::abs(their_pressure / our_pressure - 1.0),
            largest_difference_over_rms(forces, by_id(state, state.forces()))};
}

/// Largest distance between where the programs have an atom after the steps, and the relative difference of the energy
/// there.
struct Separation {
    double position;
    double energy;
};
std::string shown(const Separation& apart) {
    return fmt::format("position {:.1e}, energy {:.1e}", apart.position, apart.energy);
}
Separation separation(const Fluid& fluid, const PeerFrame& theirs, const std::string& search,
                      const std::string& integrator) {
    State state = state_of(fluid);
    PairForceField force_field(fluid.potential, make_pair_search(search, 0.3));
    advance(state, force_field, time_step, theirs.step, integrator);
    const Eigen::Matrix3Xd ours = unwrapped_by_id(state);
    double largest = 0.0;
    for (Index id = 0; id < state.count(); ++id) {
        largest = std::max(largest, (ours.col(id) - theirs.positions[static_cast<std::size_t>(id)]).norm());
    }
    const double energy = force_field.evaluate(state, Request::forces_and_energy).potential_energy;
    return {largest, std::abs(theirs.potential_energy / energy - 1.0)};
}

}  // namespace

TEST_CASE("LAMMPS finds our energy, pressure and forces, for every potential that it has") {
    if (!lammps_is_here()) {
        return;
    }
    const auto potentials = potentials_of_lammps();
    REQUIRE(potentials.size() == 7);
    REQUIRE(temperature(melt()).value() == Approx(0.72).margin(0.08));
    for (const PairPotential& potential : potentials) {
        const Fluid fluid = melt_with(potential);
        const PeerPoint theirs = make_lammps_peer(fluid, 1)->point();
        for (const char* search : {"verlet-list", "cells", "all-pairs"}) {
            const Difference difference = difference_at_start(fluid, theirs, search);
            INFO(name_of(potential) << ", " << search << ": " << shown(difference));
            CHECK(difference.energy < energy_tolerance);
            CHECK(difference.pressure < pressure_tolerance);
            CHECK(difference.force < force_tolerance);
        }
    }
}

TEST_CASE("LAMMPS takes the atoms where we take them in a hundred steps, for every potential that it has", "[long]") {
    if (!lammps_is_here()) {
        return;
    }
    for (const PairPotential& potential : potentials_of_lammps()) {
        const Fluid fluid = melt_with(potential);
        const auto peer = make_lammps_peer(fluid, 1);
        const PeerFrame theirs = peer->follow(peer->methods().at(0).name, time_step, {steps}).at(0);
        for (const char* search : {"verlet-list", "all-pairs"}) {
            const Separation apart = separation(fluid, theirs, search, "velocity-verlet");
            INFO(name_of(potential) << ", " << search << ": " << shown(apart));
            CHECK(apart.position < trajectory_tolerance);
            CHECK(apart.energy < energy_tolerance);
        }
    }
}

TEST_CASE("our leapfrog goes with LAMMPS, too") {
    if (!lammps_is_here()) {
        return;
    }
    const Fluid fluid = melt_with(PairPotential::lennard_jones("cut", default_cutoff));
    const PeerFrame theirs = make_lammps_peer(fluid, 1)->follow("fix nve", time_step, {steps}).at(0);
    const Separation apart = separation(fluid, theirs, "verlet-list", "leapfrog");
    INFO(shown(apart));
    CHECK(apart.position < trajectory_tolerance);
}

TEST_CASE("a cutoff that is 1e-4 larger is seen") {
    if (!lammps_is_here()) {
        return;
    }
    for (const char* truncation : {"cut", "shifted", "force-shifted", "switched"}) {
        const Fluid ours = melt_with(PairPotential::lennard_jones(truncation, {2.5, 2.0}));
        Fluid other = ours;
        other.potential = PairPotential::lennard_jones(truncation, {2.5 + 1e-4, 2.0});
        const Difference difference = difference_at_start(ours, make_lammps_peer(other, 1)->point(), "verlet-list");
        INFO(truncation << ": " << shown(difference));
        CHECK(difference.energy > 10.0 * energy_tolerance);
        CHECK(difference.pressure > 10.0 * pressure_tolerance);
        CHECK(difference.force > 10.0 * force_tolerance);
    }
}

TEST_CASE("a time step that is 1e-9 longer is seen") {
    if (!lammps_is_here()) {
        return;
    }
    const Fluid fluid = melt_with(PairPotential::lennard_jones("cut", default_cutoff));
    const auto peer = make_lammps_peer(fluid, 1);
    const PeerFrame theirs = peer->follow("fix nve", time_step * (1.0 + 1e-9), {steps}).at(0);
    CHECK(separation(fluid, theirs, "verlet-list", "velocity-verlet").position > 10.0 * trajectory_tolerance);
}

namespace {

/// LAMMPS run on an exported directory: columns of the first row of its first table, by name.
std::map<std::string, double> first_row(const std::filesystem::path& directory) {
    const auto program = find_program(lammps_name());
    REQUIRE(program.has_value());
    REQUIRE(run_process({.program = *program,
                         .arguments = {"-in", "in.lammps", "-log", "none", "-var", "steps", "10"},
                         .directory = directory,
                         .output = "said"}) == 0);
    TextFile said(directory / "said");
    std::vector<std::string_view> fields;
    std::vector<std::string> names;
    while (names.empty() && said.next_line()) {
        split_fields(said.line(), fields);
        if (!fields.empty() && fields[0] == "Step") {
            names.assign(fields.begin(), fields.end());
        }
    }
    REQUIRE(said.next_line());
    split_fields(said.line(), fields);
    REQUIRE(fields.size() == names.size());
    std::map<std::string, double> row;
    for (std::size_t k = 0; k < names.size(); ++k) {
        row[names[k]] = said.number(fields[k], names[k]);
    }
    return row;
}

/// What ljmd says of a configuration of a deck.
Thermodynamics ours(const Deck& deck, State state) {
    PairForceField force_field = make_force_field(fluid_spec(deck), state.execution());
    const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    const bool tail = deck.potential().has_tail();
    return thermodynamics(state, evaluation,
                          tail ? TailCorrection(pair_potential_of(deck.potential())) : TailCorrection());
}

void check_row(const std::map<std::string, double>& row, const Thermodynamics& ours) {
    CHECK(row.at("PotEng") == Approx(ours.potential_energy).epsilon(1e-12));
    CHECK(row.at("KinEng") == Approx(ours.kinetic_energy).epsilon(1e-12));
    CHECK(row.at("Temp") == Approx(ours.temperature.value()).epsilon(1e-12));
    CHECK(row.at("v_p") == Approx(ours.pressure.value()).epsilon(1e-12));
    // LAMMPS' own convention is another one.
    CHECK(row.at("Press") == Approx(*ours.pressure - *ours.temperature * ours.density / 108.0).epsilon(1e-12));
}

}  // namespace

TEST_CASE("the exported input has our energy and pressure in LAMMPS, of a start and of the end of a run") {
    if (!lammps_is_here()) {
        return;
    }
    const DeckFolder folder(
        changed(small_deck, {{"cutoff = 2.0", "cutoff = 2.5"}, {"\"force-shifted\"", "\"cut\"\ntail = true"}}));
    const std::string start = (folder / "start").string();
    const std::string run = (folder / "out").string();
    const std::string end = (folder / "end").string();
    static_cast<void>(said([&] {
        const std::string deck = folder.deck_path().string();
        command({"export", deck, "--to", "lammps", "--out", start, "--quiet"});
        command({"run", deck, "--out", run, "--quiet"});
        command({"export", run, "--to", "lammps", "--out", end, "--quiet"});
    }));
    const Deck deck = folder.load();
    check_row(first_row(start), ours(deck, simulation_of(deck).state));
    check_row(first_row(end), ours(deck, last_configuration(run, deck)));
    // The dump of the end is there, by id.
    TextFile dump(std::filesystem::path(end) / "final.lammpsdump");
    for (int line = 0; line < 10; ++line) {
        REQUIRE(dump.next_line());
    }
    CHECK(dump.line().starts_with("1 1 "));
}
