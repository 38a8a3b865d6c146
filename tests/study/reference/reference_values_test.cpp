#include "study/reference/reference_values.hpp"

#include <algorithm>
#include <numbers>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"
#include "study/reference/made_reference.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const ReferenceValue& named_value(const std::vector<ReferenceValue>& values, const std::string& name) {
    const auto found = std::ranges::find(values, name, &ReferenceValue::name);
    REQUIRE(found != values.end());
    return *found;
}

}  // namespace

TEST_CASE("energy and pressure are means of all runs, corrected for cutoff and size") {
    const ReferenceSetup setup = reference_setup(liquid_request());
    const MadeUpReplicas replicas({-5.001, -4.999, -5.0, -5.0}, {1.0, 1.0, 1.001, 0.999}, 1.2);
    replicas.merged_results(cutoff_observables());
    const auto values = canonical_values(setup, replicas.folder());
    REQUIRE(values.size() == 3);
    const ReferenceValue& energy = named_value(values, "potential_energy");
    CHECK(energy.mean.value() == Approx(-5.0 - 0.002 - setup.size.potential_energy).epsilon(1e-12));
    CHECK(energy.cutoff_correction == -0.002);
    CHECK(energy.size_correction == -setup.size.potential_energy);
    const ReferenceValue& pressure = named_value(values, "pressure");
    // p + rho (T_0 - T): the swings of p and T cancel in part, their means are p and T_0
    CHECK(pressure.mean.value() == Approx(1.0 - 0.005 - setup.size.pressure).epsilon(1e-12));
    const ReferenceValue& factor = named_value(values, "compressibility_factor");
    CHECK(factor.mean.value() == Approx(*pressure.mean / (0.75 * 1.2)).epsilon(1e-12));
    CHECK(factor.total_error() == Approx(pressure.total_error() / (0.75 * 1.2)).epsilon(1e-12));
    REQUIRE(energy.by_equations.size() == 2);
    CHECK(energy.by_equations.front().second == setup.expected.potential_energy);
}

TEST_CASE("the systematic error has the response beyond the radius, its second order, oscillations and size") {
    const ReferenceSetup setup = reference_setup(liquid_request());
    const MadeUpReplicas replicas({-5.0, -5.0}, {1.0, 1.0}, 1.2);
    replicas.merged_results(cutoff_observables());
    const ReferenceValue energy = named_value(canonical_values(setup, replicas.folder()), "potential_energy");
    const double radius = setup.counted_radius();
    const auto tail = [](double r) { return 4.0 * (std::pow(r, -9) / 9.0 - std::pow(r, -3) / 3.0); };
    const double response = 0.001;
    const double left_out = response * tail(radius) / setup.potential.tail().energy;
    const double s0 = structure_factor_at_zero(equation_of_state("thol2016"), 1.2, 0.75, 0.0);
    const double shell = 2.0 * std::numbers::pi * 0.75 * (0.01 + s0 / 864.0) * (tail(radius) - tail(radius + 0.5));
    const double size = setup.size.potential_energy - setup.size_by_other.potential_energy;
    const double tail_slope = TailCorrection(setup.potential).pressure(1.0);
    const double second =
        std::max(0.05, 2.0 * std::abs(tail_slope) * 0.75 / 1.2 *
                           structure_factor_at_zero(equation_of_state("thol2016"), 1.2, 0.75, tail_slope));
    const double expected =
        std::sqrt(second * second * response * response + left_out * left_out + shell * shell + size * size);
    CHECK(energy.systematic_error == Approx(expected).epsilon(0.02));  // the height of g is that of a bin
}

TEST_CASE("fluctuations that are slow and small below fast ones count in the error") {
    const ReferenceSetup setup = reference_setup(liquid_request());
    const MadeUpReplicas replicas({-5.0, -5.0}, {1.0, 1.0}, 1.2);
    replicas.merged_results(observable("cutoff_energy", 0.0, 1e-9) + ", " + observable("cutoff_pressure", 0.0, 1e-9));
    for (const auto& run : replicas.folder().runs) {
        std::ofstream thermo(run / "thermo.csv");
        thermo << "step,temperature,potential_energy,pressure\n";
        for (int row = 1; row <= 2000; ++row) {
            const double swing = row % 2 == 0 ? 0.01 : -0.01;
            const double slow = (row / 100) % 2 == 0 ? 0.001 : -0.001;
            thermo << fmt::format("{},1.2,{},1.0\n", 100 + 10 * row, -5.0 + swing + slow);
        }
    }
    // 62 blocks of 32 rows have means of +-0.001; block averages alone end at 125 blocks of 16 rows
    const double error = canonical_values(setup, replicas.folder()).front().statistical_error;
    CHECK(error == Approx(0.001 / std::sqrt(62.0) / std::sqrt(2.0)).epsilon(0.1));
}

TEST_CASE("runs that differ by more than their errors are remarked on") {
    const ReferenceSetup setup = reference_setup(liquid_request());
    const MadeUpReplicas replicas({-5.0, -5.1, -5.0, -5.1}, {1.0, 1.0, 1.0, 1.0}, 1.2);
    replicas.merged_results(cutoff_observables());
    const ReferenceValue energy = named_value(canonical_values(setup, replicas.folder()), "potential_energy");
    CHECK_THAT(energy.remark, Contains("the replicas differ"));
    CHECK(energy.statistical_error > 0.02);
}

TEST_CASE("response functions follow the shifts of c_v, (dp/dT)_V and K_T") {
    ReferenceRequest request = liquid_request();
    for (const char* name : {"heat_capacity_cv", "thermal_pressure_coefficient", "isothermal_compressibility",
                             "speed_of_sound", "heat_capacity_cp"}) {
        request.properties.emplace_back(name);
    }
    const ReferenceSetup setup = reference_setup(request);
    const MadeUpReplicas replicas({-5.0, -5.0}, {1.0, 1.0}, 1.2);
    const FluidProperties& eos = setup.expected;
    replicas.merged_results(cutoff_observables() + ", " + observable("heat_capacity_cv", 2.4, 0.01, "k_B") + ", " +
                            observable("thermal_pressure_coefficient", 3.8, 0.02) + ", " +
                            observable("isothermal_compressibility", 0.09, 0.002) + ", " +
                            observable("speed_of_sound", 5.3, 0.02));
    const auto values = canonical_values(setup, replicas.folder());
    CHECK(named_value(values, "heat_capacity_cv").mean.value() ==
          Approx(2.4 - setup.size.heat_capacity_cv).epsilon(1e-12));
    CHECK(named_value(values, "thermal_pressure_coefficient").mean.value() ==
          Approx(3.8 - setup.size.thermal_pressure).epsilon(1e-12));
    const double modulus = 1.0 / eos.isothermal_compressibility().value();
    CHECK(named_value(values, "isothermal_compressibility").size_correction ==
          Approx(1.0 / modulus - 1.0 / (modulus + setup.size.bulk_modulus)).epsilon(1e-9));
    const double t = 1.2;
    const double rho = 0.75;
    const double k = modulus + setup.size.bulk_modulus;
    const double g = eos.pressure_temperature_slope + setup.size.thermal_pressure;
    const double c = eos.heat_capacity_cv + setup.size.heat_capacity_cv;
    CHECK(named_value(values, "speed_of_sound").size_correction ==
          Approx(eos.speed_of_sound().value() - std::sqrt((k + t * g * g / (rho * c)) / rho)).epsilon(1e-9));
    CHECK(named_value(values, "speed_of_sound").systematic_error > 0.0);
    CHECK_FALSE(named_value(values, "heat_capacity_cp").mean);  // not among the merged results
    CHECK_FALSE(named_value(values, "heat_capacity_cp").remark.empty());
}

TEST_CASE("the chemical potential has the shift of an inserted atom, and a remark without a value") {
    ReferenceRequest request = liquid_request();
    request.properties.emplace_back("excess_chemical_potential");
    const ReferenceSetup setup = reference_setup(request);
    const MadeUpReplicas replicas({-5.0, -5.0}, {1.0, 1.0}, 1.2);
    replicas.merged_results(cutoff_observables() + ", " + observable("excess_chemical_potential", -3.0, 0.05));
    const auto found = named_value(canonical_values(setup, replicas.folder()), "excess_chemical_potential");
    CHECK(found.mean.value() == Approx(-3.0 - 0.004 - setup.size.excess_chemical_potential).epsilon(1e-12));
    replicas.merged_results(cutoff_observables());
    const auto none = named_value(canonical_values(setup, replicas.folder()), "excess_chemical_potential");
    CHECK_FALSE(none.mean);
    CHECK_FALSE(none.remark.empty());
}

TEST_CASE("diffusion is corrected for the box by the viscosity of all runs") {
    ReferenceRequest request = liquid_request();
    request.properties.insert(request.properties.end(), {"diffusion", "thermal_conductivity"});
    const ReferenceSetup setup = reference_setup(request);
    const MadeUpReplicas replicas({-5.0, -5.0}, {1.0, 1.0}, 1.2);
    replicas.merged_results(observable("diffusion", 0.08, 0.001) + ", " + observable("viscosity", 1.9, 0.1) + ", " +
                            observable("temperature", 1.201, 0.001) + ", " +
                            observable("thermal_conductivity", 5.0, 0.2));
    const auto values = transport_values(setup, replicas.folder());
    REQUIRE(values.size() == 2);
    const double more = 2.837297 * 1.201 / (6.0 * std::numbers::pi * 1.9 * setup.edge());
    CHECK(named_value(values, "diffusion").mean.value() == Approx(0.08 + more).epsilon(1e-6));
    CHECK(std::isnan(named_value(values, "thermal_conductivity").systematic_error));
    replicas.merged_results(observable("diffusion", 0.08, 0.001) + ", " + observable("temperature", 1.201, 0.001));
    CHECK_FALSE(named_value(transport_values(setup, replicas.folder()), "diffusion").mean);
}

TEST_CASE("runs that do not keep their energy give no transport coefficient") {
    ReferenceRequest request = liquid_request();
    request.properties.emplace_back("viscosity");
    const ReferenceSetup setup = reference_setup(request);
    const MadeUpReplicas replicas({-5.0, -5.0}, {1.0, 1.0}, 1.2);
    replicas.merged_results(observable("viscosity", 1.9, 0.1));
    CHECK(named_value(transport_values(setup, replicas.folder()), "viscosity").mean == 1.9);
    std::ofstream(replicas.folder().runs[1] / "results.json") << R"({"observables": {}, "stages": [
        {"sampled": true, "first_step": 100, "steps": 20000, "time_step": 0.004, "energy_drift": 0.001}]})";
    const auto found = named_value(transport_values(setup, replicas.folder()), "viscosity");
    CHECK_FALSE(found.mean);
    CHECK_THAT(found.remark, Contains("do not keep their energy"));
}

TEST_CASE("the total energy is that of atoms at rest as a whole, and a pressure gives the density") {
    ReferenceRequest request = liquid_request();
    const ReferenceSetup setup = reference_setup(request);
    const MadeUpReplicas replicas({-5.0, -5.02}, {1.0, 1.0}, 1.2);
    CHECK(found_total_energy(setup, replicas.folder()) == Approx(-5.01 + 1.8 * 863.0 / 864.0).epsilon(1e-12));

    request.density.reset();
    request.pressure = 1.0;
    const ReferenceSetup at_pressure = reference_setup(request);
    ReferenceValue pressure{.name = "pressure",
                            .symbol = "p",
                            .unit = "",
                            .mean = 0.98,
                            .statistical_error = 0.01,
                            .systematic_error = 0.005};
    const ReferenceValue density = density_at_pressure(at_pressure, pressure);
    const double slope = at_pressure.expected.pressure_density_slope;
    CHECK(density.mean.value() == Approx(at_pressure.density + 0.02 / slope).epsilon(1e-12));
    CHECK(density.total_error() == Approx(std::hypot(0.01, 0.005) / slope).epsilon(1e-12));
}
