#include "study/reference/reference_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/tables/data_table_csv.hpp"
#include "ljmd/detail/observables/statistics/wanted_errors.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "observables/transport/finite_size.hpp"
#include "study/reference/energy_kept.hpp"
#include "study/reference/merged_observables.hpp"
#include "study/replica_merge.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double least_second_order = 0.05;  // of the first-order response, left out
constexpr double last_shell = 1.0;           // [sigma] before the counted radius
constexpr double half_period = 0.5;          // [sigma] of the oscillations of g(r)
constexpr double density_derivative = 10;    // of what the cutoff does to the pressure, in K_T
constexpr Index blocks_of_replica = 16;      // of its error, at least

double squared(double x) {
    return x * x;
}

/// The error of a mean whose length it has decided.
double stopped_error(double error, std::size_t replicas) {
    const auto blocks = blocks_of_replica * static_cast<Index>(replicas);
    return stopped_estimate({0.0, error, 0.0, 0, true, blocks}).standard_error;
}

/// Mean of one series of all replicas.
struct MergedSeries {
    MergedMean mean;
    double independent = 0.0;
    bool converged = true;
};

MergedSeries merged_series(const std::vector<CanonicalSeries>& runs, std::vector<double> CanonicalSeries::*member) {
    std::vector<ReplicaMean> means;
    MergedSeries merged{};
    for (const CanonicalSeries& run : runs) {
        BlockingAccumulator blocks(1, Covariance::diagonal);
        for (const double value : run.*member) {
            blocks.add(Eigen::VectorXd::Constant(1, value));
        }
        const Estimate one = blocks.estimate(0);
        means.push_back({one.mean, one.standard_error, static_cast<double>(one.samples), one.converged});
        merged.independent += one.independent_samples;
        merged.converged = merged.converged && one.converged;
    }
    merged.mean = merged_mean(means);
    return merged;
}

/// What the cutoff leaves uncertain in energy and pressure, as standard deviations.
struct CutoffUncertainty {
    double energy;
    double pressure;
};

/// The largest |g - 1| in the last sigma before the counted radius. @param offset  of g in a box, S(0)/N
double oscillation(const fs::path& rdf, double radius, double offset) {
    const DataTable table = read_csv(rdf);
    const std::vector<double> r = column(table, "r");
    const std::vector<double> g = column(table, "g");
    double largest = 0.0;
    for (std::size_t k = 0; k < r.size(); ++k) {
        if (r[k] > radius - last_shell) {
            largest = std::max(largest, std::abs(g[k] + offset - 1.0));
        }
    }
    return largest;
}

CutoffUncertainty cutoff_uncertainty(const ReferenceSetup& setup, const ReplicaFolder& canonical,
                                     const std::vector<MergedObservable>& found) {
    const double radius = setup.counted_radius();
    const double rho = setup.density;
    const TailIntegrals beyond = setup.potential.formula_beyond(radius);
    const TailIntegrals all = setup.potential.tail();
    const auto response = [&](const char* name) {
        const auto* one = find_merged(found, name);
        return one == nullptr ? unknown : one->mean;
    };
    const double left_out = beyond.energy / all.energy;
    const double energy_response = response("cutoff_energy_response");
    const double pressure_response = response("cutoff_pressure_response");
    const EquationOfState thol = equation_of_state("thol2016");
    const double t = setup.request.temperature;
    const double s0 = structure_factor_at_zero(thol, t, rho, 0.0);
    const double tail = TailCorrection(setup.potential).pressure(1.0);
    // The tail changes 1/S(0) by this part of it.
    const double second_order =
        std::max(least_second_order, 2.0 * std::abs(tail) * rho * structure_factor_at_zero(thol, t, rho, tail) / t);
    const double height = oscillation(canonical.merged / "rdf.csv", radius, s0 / static_cast<double>(setup.atoms));
    const TailIntegrals behind = setup.potential.formula_beyond(radius + half_period);
    const double pi = std::numbers::pi;
    const double more_energy = 2.0 * pi * rho * height * (beyond.energy - behind.energy);
    const double more_pressure = 2.0 / 3.0 * pi * rho * rho * height * (beyond.virial - behind.virial);
    return {
        std::sqrt(squared(second_order * energy_response) + squared(left_out * energy_response) + squared(more_energy)),
        std::sqrt(squared(second_order * pressure_response) + squared(left_out * pressure_response) +
                  squared(more_pressure))};
}

void add_equations(ReferenceValue& value, const ReferenceSetup& setup) {
    const ReferenceProperty& property = reference_property(value.name);
    for (const char* name : {"thol2016", "kolafa-nezbeda1994"}) {
        const FluidProperties state = properties(equation_of_state(name), setup.request.temperature, setup.density);
        if (const auto number = value_by_equation(property, state)) {
            value.by_equations.emplace_back(name, *number);
        }
    }
}

ReferenceValue empty_value(const std::string& name, const std::string& unit) {
    return {.name = name,
            .symbol = symbol_of(name),
            .unit = unit,
            .statistical_error = unknown,
            .systematic_error = unknown};
}

/// Energy or pressure: a mean of the series with a correction of the cutoff.
ReferenceValue corrected_mean(const std::string& name, const std::string& unit, const MergedSeries& series,
                              const MergedObservable* correction, std::size_t replicas) {
    ReferenceValue value = empty_value(name, unit);
    value.independent = series.independent;
    value.converged = series.converged;
    if (!series.mean.agree) {
        value.remark = "the replicas differ by more than their errors let expect: its error is from their scatter";
    }
    if (correction == nullptr) {
        value.remark = "the cutoff could not be corrected";
        return value;
    }
    value.cutoff_correction = correction->mean;
    value.statistical_error =
        stopped_error(std::hypot(series.mean.standard_error, correction->standard_error), replicas);
    value.mean = series.mean.mean + correction->mean;
    return value;
}

/// c_v, (dp/dT)_V and K_T, from which all response functions follow.
struct ThreeResponses {
    double heat_capacity_cv;
    double thermal_pressure;
    double bulk_modulus;
};

/// As in docs/response-functions.md, response functions. @return none for a name that is none of them
std::optional<double> response_from(const std::string& name, const ThreeResponses& r, double t, double rho) {
    const double alpha = r.thermal_pressure / r.bulk_modulus;
    const double cp = r.heat_capacity_cv + t * squared(r.thermal_pressure) / (rho * r.bulk_modulus);
    const double adiabatic = r.bulk_modulus + t * squared(r.thermal_pressure) / (rho * r.heat_capacity_cv);
    const std::array<std::pair<const char*, double>, 7> all{
        {{"heat_capacity_cv", r.heat_capacity_cv},
         {"heat_capacity_cp", cp},
         {"isothermal_compressibility", 1.0 / r.bulk_modulus},
         {"thermal_expansion", alpha},
         {"thermal_pressure_coefficient", r.thermal_pressure},
         {"speed_of_sound", std::sqrt(adiabatic / rho)},
         {"joule_thomson_coefficient", (t * alpha - 1.0) / (rho * cp)}}};
    const auto* const found = std::ranges::find_if(all, [&](const auto& one) { return name == one.first; });
    return found == all.end() ? std::nullopt : std::optional(found->second);
}

/// A response function with the shift of the size taken off.
ReferenceValue response_value(const ReferenceSetup& setup, const MergedObservable& found,
                              const CutoffUncertainty& cutoff, std::size_t replicas) {
    const double t = setup.request.temperature;
    const double rho = setup.density;
    ReferenceValue value = empty_value(found.name, found.unit);
    value.independent = found.independent;
    value.converged = found.converged;
    value.remark = found.remark;
    value.statistical_error = stopped_error(found.standard_error, replicas);
    const ThreeResponses here{setup.expected.heat_capacity_cv, setup.expected.pressure_temperature_slope,
                              rho * setup.expected.pressure_density_slope};
    const double base = response_from(found.name, here, t, rho).value();
    const auto change = [&](double cv, double thermal, double modulus) {
        const ThreeResponses changed{here.heat_capacity_cv + cv, here.thermal_pressure + thermal,
                                     here.bulk_modulus + modulus};
        return response_from(found.name, changed, t, rho).value() - base;
    };
    const auto shift_by = [&](const SizeShift& size) {
        return change(size.heat_capacity_cv, size.thermal_pressure, size.bulk_modulus);
    };
    const double shift = shift_by(setup.size);
    value.size_correction = -shift;
    value.mean = found.mean - shift;
    value.systematic_error =
        std::sqrt(squared(shift - shift_by(setup.size_by_other)) + squared(change(2.0 / t * cutoff.energy, 0.0, 0.0)) +
                  squared(change(0.0, 2.0 / t * cutoff.pressure, 0.0)) +
                  squared(change(0.0, 0.0, density_derivative * cutoff.pressure)));
    return value;
}

ReferenceValue insertion_value(const ReferenceSetup& setup, const MergedObservable* found,
                               const std::vector<MergedObservable>& all, const CutoffUncertainty& cutoff,
                               std::size_t replicas) {
    ReferenceValue value = empty_value("excess_chemical_potential", "epsilon");
    if (found == nullptr) {
        const auto none = std::ranges::find(all, value.name, &MergedObservable::name);
        value.remark = none == all.end() || none->remark.empty()
                           ? "not all replicas have a value: too few insertions at low energies"
                           : none->remark;
        return value;
    }
    value.independent = found->independent;
    value.converged = found->converged;
    value.remark = found->remark;
    value.statistical_error = stopped_error(found->standard_error, replicas);
    value.size_correction = -setup.size.excess_chemical_potential;
    // An atom has twice the energy per atom with the others, to first order; the structure responds as in the pressure.
    const auto* energy = find_merged(all, "cutoff_energy");
    value.cutoff_correction = energy == nullptr ? 0.0 : 2.0 * energy->mean;
    value.mean = found->mean + value.cutoff_correction + value.size_correction;
    value.systematic_error = std::sqrt(
        squared(value.cutoff_correction) + squared(2.0 * cutoff.energy) + squared(cutoff.pressure / setup.density) +
        squared(setup.size.excess_chemical_potential - setup.size_by_other.excess_chemical_potential));
    return value;
}

std::vector<CanonicalSeries> all_series(const ReferenceSetup& setup, const ReplicaFolder& folder) {
    std::vector<CanonicalSeries> series;
    series.reserve(folder.runs.size());
    for (const fs::path& run : folder.runs) {
        series.push_back(canonical_series(run, setup.density, setup.request.temperature));
    }
    return series;
}

}  // namespace

double ReferenceValue::total_error() const {
    return std::hypot(statistical_error, systematic_error);
}

std::vector<ReferenceValue> canonical_values(const ReferenceSetup& setup, const ReplicaFolder& canonical) {
    const std::vector<CanonicalSeries> series = all_series(setup, canonical);
    const std::vector<MergedObservable> found = merged_observables(canonical.merged);
    const CutoffUncertainty cutoff = cutoff_uncertainty(setup, canonical, found);
    const std::size_t replicas = canonical.runs.size();

    ReferenceValue energy =
        corrected_mean("potential_energy", "epsilon", merged_series(series, &CanonicalSeries::energy),
                       find_merged(found, "cutoff_energy"), replicas);
    ReferenceValue pressure =
        corrected_mean("pressure", "epsilon/sigma^3", merged_series(series, &CanonicalSeries::pressure),
                       find_merged(found, "cutoff_pressure"), replicas);
    const auto take_off = [](ReferenceValue& value, double shift, double other, double uncertain) {
        if (value.mean) {
            value.size_correction = -shift;
            *value.mean -= shift;
            value.systematic_error = std::hypot(uncertain, shift - other);
        }
    };
    take_off(energy, setup.size.potential_energy, setup.size_by_other.potential_energy, cutoff.energy);
    take_off(pressure, setup.size.pressure, setup.size_by_other.pressure, cutoff.pressure);

    ReferenceValue factor = empty_value("compressibility_factor", "1");
    const double ideal = setup.density * setup.request.temperature;
    if (pressure.mean) {
        factor.mean = *pressure.mean / ideal;
    }
    factor.statistical_error = pressure.statistical_error / ideal;
    factor.systematic_error = pressure.systematic_error / ideal;
    factor.cutoff_correction = pressure.cutoff_correction / ideal;
    factor.size_correction = pressure.size_correction / ideal;
    factor.independent = pressure.independent;
    factor.converged = pressure.converged;
    factor.remark = pressure.remark;

    std::vector<ReferenceValue> values{energy, pressure, factor};
    for (const std::string& name : setup.request.properties) {
        const MeasuredBy measured = reference_property(name).measured;
        const auto* merged = find_merged(found, name);
        if (measured == MeasuredBy::responses) {
            if (merged == nullptr) {
                ReferenceValue none = empty_value(name, find_quantity(name)->unit);
                none.remark = "the runs are too short for it";
                values.push_back(none);
            } else {
                values.push_back(response_value(setup, *merged, cutoff, replicas));
            }
        } else if (measured == MeasuredBy::insertion) {
            values.push_back(insertion_value(setup, merged, found, cutoff, replicas));
        }
    }
    for (ReferenceValue& value : values) {
        add_equations(value, setup);
    }
    return values;
}

std::vector<ReferenceValue> transport_values(const ReferenceSetup& setup, const ReplicaFolder& transport) {
    const std::vector<MergedObservable> found = merged_observables(transport.merged);
    const std::size_t replicas = transport.runs.size();
    const bool keeps_energy = temperature_uncertainty(transport.runs, setup.request.temperature) <= largest_uncertainty;
    std::vector<ReferenceValue> values;
    for (const std::string& name : setup.request.properties) {
        if (reference_property(name).measured != MeasuredBy::transport) {
            continue;
        }
        ReferenceValue value = empty_value(name, find_quantity(name)->unit);
        const auto* merged = find_merged(found, name);
        if (merged == nullptr || !keeps_energy) {
            value.remark = keeps_energy ? "the runs are too short for it" : "the runs do not keep their energy";
            value.withheld = !keeps_energy;
            values.push_back(value);
            continue;
        }
        value.mean = merged->mean;
        value.statistical_error = stopped_error(merged->standard_error, replicas);
        value.independent = merged->independent;
        value.converged = merged->converged;
        value.remark = merged->remark;
        if (name == "diffusion") {
            std::vector<ObservableAverage> averages;
            for (const char* needed : {"diffusion", "viscosity", "temperature"}) {
                if (const auto* one = find_merged(found, needed)) {
                    averages.push_back({needed, "", one->unit,
                                        Estimate{one->mean, one->standard_error, one->independent, 1, one->converged}});
                }
            }
            const auto infinite = diffusion_in_infinite_system(averages, Box(Vec3::Constant(setup.edge())));
            if (!infinite || !infinite->estimate) {
                value.mean.reset();
                value.remark = "the viscosity is not known, and without it not the correction for the size of the box";
            } else {
                value.size_correction = infinite->estimate->mean - merged->mean;
                value.mean = infinite->estimate->mean;
                value.statistical_error = stopped_error(infinite->estimate->standard_error, replicas);
            }
        }
        values.push_back(value);
    }
    return values;
}

double found_total_energy(const ReferenceSetup& setup, const ReplicaFolder& canonical) {
    const double energy = merged_series(all_series(setup, canonical), &CanonicalSeries::energy).mean.mean;
    const auto atoms = static_cast<double>(setup.atoms);
    return energy + 1.5 * setup.request.temperature * (atoms - 1.0) / atoms;
}

ReferenceValue density_at_pressure(const ReferenceSetup& setup, const ReferenceValue& pressure) {
    const double slope = setup.expected.pressure_density_slope;
    ReferenceValue density = empty_value("density", "sigma^-3");
    density.mean = setup.density + (setup.request.pressure.value() - pressure.mean.value()) / slope;
    density.statistical_error = pressure.statistical_error / slope;
    density.systematic_error = pressure.systematic_error / slope;
    density.independent = pressure.independent;
    density.converged = pressure.converged;
    density.by_equations.emplace_back("thol2016", setup.density);
    return density;
}

}  // namespace ljmd
