#include "ljmd/deck/asked_temperature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/at_temperature.hpp"
#include "ljmd/deck/deck_potential.hpp"
#include "ljmd/deck/sampled_run.hpp"
#include "ljmd/deck/simulation.hpp"
#include "ljmd/reference/equation_doubts.hpp"

namespace ljmd {

namespace {

constexpr double noticeable_errors = 3.0;
constexpr double rounding = 1e-9;       // of the temperature: a value that is held exactly has no error
constexpr double farthest_shift = 0.1;  // of the temperature: the range in which the slope of an equation is reliable
constexpr double least_full_cutoff = 2.5;  // [sigma]: beyond it, a tail with g = 1 gives the full fluid
constexpr double thol2015_cutoff = 2.5;    // [sigma]

bool is_off(double asked, const Estimate& found) {
    return std::abs(found.mean - asked) > std::max(noticeable_errors * found.standard_error, rounding * asked);
}

bool is_held(const Deck& deck) {
    return std::ranges::any_of(deck.stages, [](const Stage& stage) { return stage.sample && stage.thermostat; });
}

std::string in_words(double temperature, const Deck& deck) {
    return deck.units ? fmt::format("{:.6g} ({:.5g} K)", temperature, temperature * deck.units->kelvin())
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

std::optional<double> asked_temperature(const Deck& deck) {
    std::optional<double> latest;
    if (deck.system().has("temperature")) {
        latest = deck.system().number("temperature");
    }
    std::optional<double> asked;
    for (const Stage& stage : deck.stages) {
        if (stage.steps == 0) {
            continue;
        }
        if (stage.thermostat) {
            latest = stage.temperature;
        }
        if (stage.sample) {
            if (asked && asked != latest) {
                return std::nullopt;
            }
            asked = latest;
        }
    }
    return asked;
}

std::string temperature_remark(const Deck& deck, const std::optional<Estimate>& found) {
    const auto asked = asked_temperature(deck);
    if (!asked || !found || !std::isfinite(found->standard_error) || !is_off(*asked, *found)) {
        return "";
    }
    return fmt::format("asked {}, found {}: {}", in_words(*asked, deck), in_words(found->mean, deck),
                       is_held(deck)
                           ? "the thermostat has not brought it there; equilibrate longer, or take a smaller time step"
                           : "at constant energy the temperature is a result; a canonical thermostat holds it");
}

std::optional<EquationOfState> equation_of_fluid(const Deck& deck) {
    const PairPotential potential = pair_potential_of(deck.potential());
    const double radius = potential.cutoff().radius;
    if (potential.formula() != "lennard-jones") {
        return std::nullopt;
    }
    if (potential.truncation() == "cut" && wants_tail(deck) && radius >= least_full_cutoff) {
        return equation_of_state("thol2016");
    }
    if (potential.truncation() == "shifted" && std::abs(radius - thol2015_cutoff) < rounding) {
        return equation_of_state("thol2015");
    }
    return std::nullopt;
}

std::optional<AtAskedTemperature> at_asked_temperature(const Deck& deck, double density, const RunAverages& averages) {
    if (sampled_ensemble(deck) != Ensemble::constant_energy) {
        return std::nullopt;
    }
    const auto asked = asked_temperature(deck);
    const auto equation = equation_of_fluid(deck);
    const MeansOfState means = averages.means_of_state();
    const auto estimate = [&](double value, const Vec3& gradient) { return averages.estimate(value, gradient); };
    const Estimate found = estimate(means[0], Vec3(1.0, 0.0, 0.0));
    if (!asked || !equation || temperature_remark(deck, found).empty() ||
        std::abs(found.mean - *asked) > farthest_shift * *asked || !is_good_at(*equation, *asked, density) ||
        !is_good_at(*equation, found.mean, density)) {
        return std::nullopt;
    }
    const AtTemperature there = at_temperature(*equation, density, *asked, means, estimate);
    return AtAskedTemperature{*asked,
                              equation->name,
                              {{"potential_energy", "U/N", "epsilon", there.potential_energy},
                               {"pressure", "p", "epsilon/sigma^3", there.pressure},
                               {"compressibility_factor", "Z", "1", there.compressibility_factor}}};
}

}  // namespace ljmd
