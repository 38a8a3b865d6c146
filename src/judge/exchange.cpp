#include "judge/exchange.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/lammps_input.hpp"
#include "integrators/thermostat.hpp"
#include "io/formats/configuration_reader.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"
#include "model/velocities.hpp"
#include "run/output_guard.hpp"

namespace ljmd {

namespace {

std::string in_words(const PairPotential& potential, bool tail) {
    const std::string& how = potential.truncation();
    const double radius = potential.cutoff().radius;
    const std::string sentence =
        how == "cut"
            ? fmt::format("u(r) for r < {0:g}, 0 beyond: energies jump at the cutoff, forces have no impulse there",
                          radius)
        : how == "shifted" ? fmt::format("u(r) - u({0:g}) for r < {0:g}, 0 beyond", radius)
        : how == "force-shifted"
            ? fmt::format("u(r) - u({0:g}) - (r - {0:g}) u'({0:g}) for r < {0:g}, 0 beyond", radius)
            : fmt::format(
                  "u(r) for r < {1:g}; u(r) (1 - 10 x^3 + 15 x^4 - 6 x^5) with x = (r - {1:g})/({0:g} - {1:g}) "
                  "up to {0:g}, 0 beyond",
                  radius, potential.cutoff().switch_start);
    return sentence + (tail ? "; tail corrections are added to energy and pressure" : "; no tail corrections");
}

Data potential_data(const Problem& problem) {
    const PairPotential& potential = problem.fluid.potential;
    Data parameters = Data::object();
    for (const auto& [name, value] : potential.parameters()) {
        parameters[name] = value;
    }
    const double density = static_cast<double>(problem.fluid.masses.size()) / problem.fluid.edges.prod();
    const TailCorrection tail = problem.fluid.tail ? TailCorrection(potential) : TailCorrection();
    Data data = {{"type", potential.formula()},
                 {"formula", potential.expression()},
                 {"parameters", parameters},
                 {"truncation", potential.truncation()},
                 {"cutoff", potential.cutoff().radius}};
    if (PairPotential::takes_switch_start(potential.truncation())) {
        data["switch_start"] = potential.cutoff().switch_start;
    }
    data["in_words"] = in_words(potential, problem.fluid.tail);
    data["tail"] = problem.fluid.tail;
    data["tail_energy_per_atom"] = tail.energy(density);
    data["tail_pressure"] = tail.pressure(density);
    return data;
}

Data run_data(const Problem& problem) {
    const Stage& stage = problem.stage;
    Data data = {{"ensemble", ensemble_of(stage)},
                 {"time_step", stage.time_step},
                 {"steps", stage.steps},
                 {"thermo_every", problem.thermo_every},
                 {"degrees_of_freedom", freedom_of(stage, std::ssize(problem.fluid.masses))}};
    if (stage.thermostat) {
        data["temperature"] = stage.temperature;
    }
    if (const auto pressure = held_pressure(stage)) {
        data["pressure"] = *pressure;
    }
    return data;
}

Data wanted(const Problem& problem) {
    Data data = Data::object();
    if (problem.wants("point")) {
        data["point.json"] =
            "of start.xyz: potential_energy (of all atoms, with tail), kinetic_energy, temperature (2 K/(3 N - 3)), "
            "virial (W = sum over pairs of r . f, without tail), pressure ((2 K + W)/(3 V), with tail), forces ([[fx, "
            "fy, fz], ...] by id; or as point.xyz, point.dump or point.h5md)";
    }
    if (problem.wants("trajectory")) {
        data["frames.xyz"] =
            "at constant energy from start.xyz, at the steps of trajectory.frames: step, positions, velocities and "
            "forces; or frames.dump, frames.h5md";
    }
    if (problem.wants("averages")) {
        data["thermo.csv"] =
            "of the run: a header, then every thermo_every steps a row with step and any of potential_energy, "
            "kinetic_energy, temperature (2 K/run.degrees_of_freedom), pressure, volume, as in point.json";
    }
    return data;
}

}  // namespace

bool Problem::wants(const std::string& part) const {
    return parts.empty() || std::ranges::find(parts, part) != parts.end();
}

std::string ensemble_of(const Stage& stage) {
    return stage.barostat ? "NPT" : stage.thermostat ? "NVT" : "NVE";
}

Index freedom_of(const Stage& stage, Index atoms) {
    return stage.thermostat && !find_thermostat(stage.thermostat->name).conserves_momentum ? 3 * atoms
                                                                                           : degrees_of_freedom(atoms);
}

std::string problem_json(const Problem& problem) {
    const Fluid& fluid = problem.fluid;
    const auto atoms = static_cast<Index>(fluid.masses.size());
    Data json = {{"format", "ljmd exchange"},
                 {"version", 1},
                 {"units", "reduced: sigma = epsilon = m = k_B = 1, time in tau = sigma (m/epsilon)^(1/2)"},
                 {"atoms", atoms},
                 {"mass", 1.0},
                 {"box_edges", Data::list({fluid.edges[0], fluid.edges[1], fluid.edges[2]})},
                 {"boundary", "periodic in all directions, with a corner at the origin"},
                 {"deck_hash", problem.deck_hash},
                 {"steps_before", problem.steps_before},
                 {"potential", potential_data(problem)}};
    json["trajectory"] = {{"ensemble", "NVE"},
                          {"integrator", "velocity Verlet, or leapfrog with v(-dt/2) = v(0) - a(0) dt/2"},
                          {"time_step", problem.stage.time_step},
                          {"steps", problem.trajectory_steps},
                          {"frames", problem.frames}};
    json["run"] = run_data(problem);
    json["wanted"] = wanted(problem);
    return to_json(json) + "\n";
}

void write_problem(const Problem& problem, const std::filesystem::path& directory, bool force) {
    const Replacing allowed{.force = force, .instead = another_directory};
    const State state = state_of(problem.fluid);
    write_output(directory / ExchangeFiles::start_for_lammps, allowed, lammps_data(problem.fluid));
    write_output(directory / ExchangeFiles::start, allowed,
                 [&](OutputFile& file) { write_extended_xyz_frame(file, state, {.velocities = true}, std::nullopt); });
    write_output(directory / ExchangeFiles::problem, allowed, problem_json(problem));
}

Fluid read_start(const std::filesystem::path& directory, const PairPotential& potential, bool tail) {
    const std::filesystem::path path = directory / ExchangeFiles::start;
    const Configuration start = read_configuration(path, std::nullopt);
    if (start.velocities.empty()) {
        throw DataError(fmt::format("{} has no velocities: it is not the file that ljmd wrote there", path.string()));
    }
    Fluid fluid{start.edges,     potential,       tail, std::vector<double>(start.positions.size(), 1.0),
                start.positions, start.velocities};
    return fluid_of(state_of(fluid), potential, tail);
}

}  // namespace ljmd
