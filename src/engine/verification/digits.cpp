#include "engine/verification/digits.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/simulation.hpp"
#include "model/atoms_by_id.hpp"

namespace ljmd {

namespace {

struct Problem {
    const char* name;
    Precision precision;
    const char* wanted;          ///< the hash
    const char* wanted_unfused;  ///< where products in single precision are not fused with sums; null: the same
    FluidSpec spec;
};

/// Liquid argon that was melted under friction and noise: the pair sum, lists, random numbers.
FluidSpec liquid() {
    FluidSpec spec;
    spec.stages = {{.name = "melt", .steps = 200, .temperature = 1.5, .thermostat = thermostat("langevin")},
                   {.name = "production", .steps = 400, .sample = true}};
    return spec;
}

/// What else the digits of a run can come from: exponentials, roots, gamma variates, a box that changes.
FluidSpec held() {
    FluidSpec spec{.start = LatticeStart{.cells = 4}, .density = 0.8, .temperature = 1.2};
    spec.potential = PairPotential::make("morse", "switched", {.radius = 2.2, .switch_start = 1.9},
                                         {{"well_depth", 1.1}, {"steepness", 5.5}, {"minimum", 1.13}});
    spec.tail = false;
    spec.stages = {{.name = "chain", .time_step = 0.002, .steps = 100, .thermostat = thermostat("nose-hoover-chain")},
                   {.name = "pressure",
                    .time_step = 0.002,
                    .steps = 300,
                    .sample = true,
                    .thermostat = thermostat("stochastic-rescaling"),
                    .barostat = barostat("stochastic-cell-rescaling", {{"pressure", 1.0}})}};
    return spec;
}

std::vector<Problem> problems() {
    return {{"liquid argon, 864 atoms", Precision::double_precision, "b1a92deb3ad9a476", nullptr, liquid()},
            {"256 atoms at constant pressure", Precision::double_precision, "ce8f64327f11e6b6", nullptr, held()},
            {"liquid argon in mixed precision", Precision::mixed, "0f60c3a31cda79ef", "9c27d0b5eb1a51b3", liquid()}};
}

std::string hash_of(const Simulation& simulation) {
    std::vector<double> numbers;
    const State& state = simulation.state();
    visit_by_id(state, {.positions = true, .velocities = true}, [&](const AtomPiece& piece) {
        for (const std::vector<Vec3>& vectors : {piece.unwrapped(state), piece.velocities}) {
            for (const Vec3& v : vectors) {
                numbers.insert(numbers.end(), v.begin(), v.end());
            }
        }
    });
    for (const ThermoRow& row : simulation.samples()) {
        numbers.insert(numbers.end(), {row.values.potential_energy, row.values.total_energy,
                                       row.values.pressure.value_or(0.0), row.conserved_energy.value_or(0.0)});
    }
    return fmt::format("{:016x}", XXH3_64bits(numbers.data(), numbers.size() * sizeof(double)));
}

}  // namespace

std::vector<DigitsOfRun> verify_digits(const ExecutionOptions& options) {
    if (!has_common_digits(options.simd)) {
        throw InputError(fmt::format("the SIMD level {} has digits of its own: verify another", name(options.simd)));
    }
    std::vector<DigitsOfRun> all;
    for (Problem& problem : problems()) {
        ExecutionOptions with = options;
        with.precision = problem.precision;
        Simulation simulation(std::move(problem.spec), Execution(with));
        simulation.run();
        const bool unfused = problem.wanted_unfused != nullptr && !fuses_single_precision(options.simd);
        all.push_back({problem.name, digits_rule(options.simd, problem.precision),
                       unfused ? problem.wanted_unfused : problem.wanted, hash_of(simulation)});
    }
    return all;
}

}  // namespace ljmd
