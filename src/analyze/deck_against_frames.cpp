#include "analyze/deck_against_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ljmd {

namespace {

/// Threshold between 0 at constant energy and 1 in the canonical ensemble.
constexpr double constant_or_canonical = 0.5;
constexpr double temperature_errors = 5.0;
constexpr double temperature_fraction = 0.05;

/// What relies on the fluctuations of the deck's ensemble.
constexpr std::array<const char*, 8> of_fluctuations{
    "heat_capacity_cv", "isothermal_compressibility", "thermal_expansion",         "thermal_pressure_coefficient",
    "heat_capacity_cp", "adiabatic_compressibility",  "joule_thomson_coefficient", "speed_of_sound"};

/// Why the frames do not fluctuate as in the deck's ensemble; empty if there is no contradiction.
std::string against_fluctuations(Ensemble ensemble, const EnergyFluctuations& energies,
                                 std::optional<Index> box_changes) {
    if (ensemble == Ensemble::isothermal_isobaric) {
        return box_changes ? "" : "the deck is one of constant pressure, but the box stays the same";
    }
    if (box_changes) {
        return fmt::format("the box changes, in frame {}: the fluctuations are not those at constant volume",
                           *box_changes);
    }
    const auto ratio = energies.total_over_kinetic();
    if (!ratio) {
        return "";
    }
    const std::string found =
        fmt::format("the total energy of the frames fluctuates {:.2g} times as much as the kinetic energy", *ratio);
    if (ensemble == Ensemble::constant_energy && *ratio > constant_or_canonical) {
        return fmt::format("the deck is one of constant energy, but {}", found);
    }
    if (ensemble == Ensemble::canonical && *ratio < constant_or_canonical) {
        return fmt::format("the deck is one of constant temperature, but {}", found);
    }
    return "";
}

std::string against_temperature(const std::vector<ObservableAverage>& averages, double held) {
    const auto found = std::ranges::find(averages, "temperature", &ObservableAverage::name);
    if (found == averages.end() || !found->estimate) {
        return "";
    }
    const double mean = found->estimate->mean;
    const double error = found->estimate->standard_error;
    const double off = std::abs(mean - held);
    if (!(off > temperature_errors * error && off > temperature_fraction * held)) {
        return "";
    }
    return fmt::format("the thermostat of the deck holds T = {:.4g}, but the frames have {:.4g}", held, mean);
}

void take_back(std::vector<ObservableAverage>& averages, const char* name, const std::string& remark) {
    for (ObservableAverage& average : averages) {
        if (average.name == name && !remark.empty()) {
            average.estimate.reset();
            average.remark = remark;
        }
    }
}

}  // namespace

void EnergyFluctuations::add_to(Series& series, double value, double count) {
    const double from_old = value - series.mean;
    series.mean += from_old / count;
    series.squares += from_old * (value - series.mean);
}

void EnergyFluctuations::add(const Thermodynamics& frame) {
    count_ += 1.0;
    add_to(total_, frame.total_energy, count_);
    add_to(kinetic_, frame.kinetic_energy, count_);
}

std::optional<double> EnergyFluctuations::total_over_kinetic() const {
    if (!(kinetic_.squares > 0.0)) {
        return std::nullopt;
    }
    return std::sqrt(total_.squares / kinetic_.squares);
}

void withdraw_contradicted(std::vector<ObservableAverage>& averages, const DeckClaims& deck,
                           const EnergyFluctuations& energies, std::optional<Index> box_changes) {
    const std::string against = against_fluctuations(deck.ensemble, energies, box_changes);
    for (const char* name : of_fluctuations) {
        take_back(averages, name, against);
    }
    if (deck.held_temperature) {
        take_back(averages, "excess_chemical_potential", against_temperature(averages, *deck.held_temperature));
    }
}

}  // namespace ljmd
