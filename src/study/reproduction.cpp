#include "study/reproduction.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/deck.hpp"
#include "engine/at_temperature.hpp"
#include "io/tables/data_table_csv.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/potentials/formulas/lennard_jones.hpp"
#include "ljmd/engine/choices.hpp"
#include "ljmd/run/spec_deck.hpp"
#include "run/recorded_results.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr double verlet_cutoff = 2.5;
constexpr double verlet_step = 0.0046188;  // 0.032 (m sigma^2/48 epsilon)^(1/2)
constexpr double melting_temperature = 3.0;

ZAndU values_of(const EquationOfState& equation, double temperature, double density) {
    const FluidProperties state = properties(equation, temperature, density);
    return {state.compressibility_factor, state.potential_energy};
}

/// Temperature, potential energy and pressure in the production stage.
BlockingAccumulator production_series(const fs::path& path, Index first_step) {
    const DataTable thermo = read_csv(path);
    const auto step = step_column(thermo, path);
    const auto temperature = full_column(thermo, "temperature", path);
    const auto energy = full_column(thermo, "potential_energy", path);
    const auto pressure = full_column(thermo, "pressure", path);
    BlockingAccumulator series(3, Covariance::full);
    for (std::size_t k = 0; k < step.size(); ++k) {
        if (step[k] > first_step) {
            series.add(Eigen::Vector3d(temperature[k], energy[k], pressure[k]));
        }
    }
    if (series.samples() == 0) {
        throw DataError(
            fmt::format("{} has no row behind step {}, where production begins", path.string(), first_step));
    }
    return series;
}

/// g(r), as written by a run.
DataTable read_rdf(const fs::path& path) {
    DataTable rdf = read_csv(path);
    if (rdf.rows.size() < 2) {
        throw DataError(fmt::format("{} has {} rows: no g(r) is as short", path.string(), rdf.rows.size()));
    }
    return rdf;
}

/// The sampled stage of a row.
RecordedStage sampled_stage(const fs::path& path) {
    const std::vector<RecordedStage> stages = read_results(path).stages;
    const auto sampled = std::ranges::find_if(stages, &RecordedStage::sampled);
    if (sampled == stages.end()) {
        throw DataError(
            fmt::format("{} is not the result of a run: it tells of no stage that was sampled", path.string()));
    }
    return *sampled;
}

/// Z and U at the nominal temperature, converted from the measured one.
void estimate_at(ReproducedRow& row, const BlockingAccumulator& series) {
    const AtTemperature nominal =
        at_temperature(equation_of_state("thol2016"), row.verlet.density, row.verlet.temperature, series.mean(),
                       [&](double value, const Vec3& gradient) { return series.estimate(value, gradient); });
    row.z = nominal.compressibility_factor;
    row.u = nominal.potential_energy;
}

bool is_sound(const std::optional<Printed>& printed) {
    return printed && printed->soundness == Soundness::sound;
}

}  // namespace

std::string row_name(const VerletRow& row) {
    return fmt::format("rho{:.4f}-T{:.3f}", row.density, row.temperature);
}

std::string row_deck(const VerletRow& row, const ReproductionLength& length) {
    constexpr std::uint64_t year = 1967;
    const auto stage = [](const char* name, Index steps) {
        return Stage{.name = name, .time_step = verlet_step, .steps = steps};
    };
    Stage melt = stage("melt", length.melt);
    melt.temperature = std::max(melting_temperature, row.temperature);
    melt.thermostat = thermostat("rescale", {{"every", 10}});
    Stage equilibrate = stage("equilibrate", length.equilibrate);
    equilibrate.thermostat = thermostat("rescale", {{"every", 20}});
    Stage production = stage("production", length.production);
    production.sample = true;
    const FluidSpec spec{.start = LatticeStart{.cells = 6},
                         .density = row.density,
                         .temperature = row.temperature,
                         .seed = year,
                         .potential = PairPotential::lennard_jones("cut", {verlet_cutoff}),
                         .tail = true,
                         .stages = {melt, equilibrate, production},
                         .sample_every = 5,
                         .analyses = {analysis("rdf", {{"bins", 250}, {"every", 25}})}};
    return deck_text(spec,
                     {.title = fmt::format("Verlet 1967: density {}, temperature {}", row.density, row.temperature)});
}

ZAndU ReproducedRow::z_scores() const {
    return {(z.mean + beyond_cutoff.z - thol.z) / z.standard_error,
            (u.mean + beyond_cutoff.u - thol.u) / u.standard_error};
}

bool ReproducedRow::precise(const ReproductionLength& length) const {
    return steps >= length.production * length.max_parts ||
           (z.converged && u.converged && z.standard_error <= length.largest_error_z &&
            u.standard_error <= length.largest_error_u);
}

ZAndU cutoff_bias(const std::vector<double>& r, const std::vector<double>& g, double density, double temperature,
                  double cutoff) {
    const LennardJones formula;
    const double width = r[1] - r[0];
    double energy = 0.0;
    double virial = 0.0;
    for (std::size_t k = 0; k < r.size(); ++k) {
        if (r[k] > cutoff) {
            const auto [u, w] = pair_term(formula, r[k] * r[k]);
            energy += (g[k] - 1.0) * u * r[k] * r[k] * width;
            virial += (g[k] - 1.0) * w * std::pow(r[k], 4) * width;
        }
    }
    return {2.0 * std::numbers::pi * density / (3.0 * temperature) * virial, 2.0 * std::numbers::pi * density * energy};
}

ReproducedRow evaluate_row(const VerletRow& row, const fs::path& directory) {
    const double rho = row.density;
    const double t = row.temperature;
    const RecordedStage stage = sampled_stage(directory / "results.json");
    const BlockingAccumulator series = production_series(directory / "thermo.csv", stage.first_step);
    const DataTable rdf = read_rdf(directory / "rdf.csv");
    ReproducedRow result{.verlet = row,
                         .steps = stage.steps,
                         .temperature = series.estimate(0),
                         .z = {},
                         .u = {},
                         .beyond_cutoff = cutoff_bias(column(rdf, "r"), column(rdf, "g"), rho, t, verlet_cutoff),
                         .thol = values_of(equation_of_state("thol2016"), t, rho),
                         .kolafa = values_of(equation_of_state("kolafa-nezbeda1994"), t, rho)};
    estimate_at(result, series);
    return result;
}

ChiSquare chi_square(const std::vector<ReproducedRow>& rows) {
    ChiSquare sum{0.0, 0, 0.0, 0};
    for (const ReproducedRow& row : rows) {
        const auto [z, u] = row.z_scores();
        if (is_sound(row.verlet.compressibility_factor)) {
            sum.z += z * z;
            ++sum.z_count;
        }
        if (is_sound(row.verlet.potential_energy)) {
            sum.u += u * u;
            ++sum.u_count;
        }
    }
    return sum;
}

}  // namespace ljmd
