#include "ljmd/detail/engine/requested_temperature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/at_temperature.hpp"
#include "engine/mistakes/film_mistakes.hpp"
#include "ljmd/core/errors.hpp"
#include "reference/equation_doubts.hpp"

namespace ljmd {

namespace {

constexpr double noticeable_errors = 3.0;
constexpr double rounding = 1e-9;        // of the temperature: a value that is held exactly has no error
constexpr double farthest_shift = 0.1;   // of the temperature: the range in which the slope of an equation is reliable
constexpr double min_full_cutoff = 2.5;  // [sigma]: beyond it, a tail with g = 1 gives the full fluid
constexpr double thol2015_cutoff = 2.5;  // [sigma]

bool is_off(double requested, const Estimate& found) {
    return std::abs(found.mean - requested) > std::max(noticeable_errors * found.standard_error, rounding * requested);
}

bool is_held(const FluidSpec& spec) {
    return std::ranges::any_of(spec.stages, [](const Stage& stage) { return stage.sample && stage.thermostat; });
}

std::string temperature_in_words(double temperature, const FluidSpec& spec) {
    return spec.units ? fmt::format("{:.6g} ({:.5g} K)", temperature, temperature * spec.units->kelvin())
                      : fmt::format("{:.6g}", temperature);
}

/// Whether the equation describes one stable phase there, within its fitted range.
bool is_good_at(const EquationOfState& equation, double temperature, double density) {
    try {
        return doubts(equation, temperature, density).empty();
    } catch (const PhysicsError&) {  // no pressure, or no coexistence found
        return false;
    }
}

}  // namespace

std::optional<double> requested_temperature(const FluidSpec& spec) {
    std::optional<double> latest = spec.temperature;
    std::optional<double> requested;
    for (const Stage& stage : spec.stages) {
        if (stage.steps == 0) {
            continue;
        }
        if (stage.thermostat) {
            latest = stage.temperature ? stage.temperature : spec.temperature;
        } else if (stage.total_energy) {
            latest.reset();  // an energy is asked for, and no temperature
        }
        if (stage.sample) {
            if (requested && requested != latest) {
                return std::nullopt;
            }
            requested = latest;
        }
    }
    return requested;
}

std::string temperature_remark(const FluidSpec& spec, const std::optional<Estimate>& found) {
    const auto requested = requested_temperature(spec);
    if (!requested || !found || !std::isfinite(found->standard_error) || !is_off(*requested, *found)) {
        return "";
    }
    return fmt::format(
        "asked {}, found {}: {}", temperature_in_words(*requested, spec), temperature_in_words(found->mean, spec),
        is_held(spec) ? "the thermostat has not brought it there; equilibrate longer, or take a smaller time step"
                      : "at constant energy the temperature is a result; a canonical thermostat holds it");
}

std::optional<EquationOfState> equation_of_fluid(const FluidSpec& spec) {
    const PairPotential& potential = spec.potential;
    const double radius = potential.cutoff().radius;
    if (potential.formula() != "lennard-jones" || spec.external || is_film(spec)) {
        return std::nullopt;
    }
    if (potential.truncation() == "cut" && spec.has_tail() && radius >= min_full_cutoff) {
        return equation_of_state("thol2016");
    }
    if (potential.truncation() == "shifted" && std::abs(radius - thol2015_cutoff) < rounding) {
        return equation_of_state("thol2015");
    }
    return std::nullopt;
}

std::optional<AtRequestedTemperature> at_requested_temperature(const FluidSpec& spec, double density,
                                                               const RunAverages& averages) {
    if (sampled_ensemble(spec.stages, spec.external != nullptr) != Ensemble::constant_energy) {
        return std::nullopt;
    }
    const auto requested = requested_temperature(spec);
    const auto equation = equation_of_fluid(spec);
    const MeansOfState means = averages.means_of_state();
    const auto estimate = [&](double value, const Vec3& gradient) { return averages.estimate(value, gradient); };
    const Estimate found = estimate(means[0], Vec3(1.0, 0.0, 0.0));
    if (!requested || !equation || temperature_remark(spec, found).empty() ||
        std::abs(found.mean - *requested) > farthest_shift * *requested ||
        !is_good_at(*equation, *requested, density) || !is_good_at(*equation, found.mean, density)) {
        return std::nullopt;
    }
    const AtTemperature there = at_temperature(*equation, density, *requested, means, estimate);
    return AtRequestedTemperature{*requested,
                                  equation->name,
                                  {{"potential_energy", "U/N", "epsilon", there.potential_energy},
                                   {"pressure", "p", "epsilon/sigma^3", there.pressure},
                                   {"compressibility_factor", "Z", "1", there.compressibility_factor}}};
}

}  // namespace ljmd
