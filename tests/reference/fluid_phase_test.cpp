#include "ljmd/reference/fluid_phase.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

const EquationOfState phased = equation_of_state("thol2016");

FluidPhase phase_at(double temperature, double density) {
    return phase_of_state(phased, temperature, density).phase;
}

}  // namespace

TEST_CASE("the isotherm T = 0.9 passes all phases in their order") {
    CHECK(phase_at(0.9, 0.010) == FluidPhase::gas);
    CHECK(phase_at(0.9, 0.016) == FluidPhase::metastable_gas);
    CHECK(phase_at(0.9, 0.300) == FluidPhase::two_phases);
    CHECK(phase_at(0.9, 0.745) == FluidPhase::metastable_liquid);
    CHECK(phase_at(0.9, 0.800) == FluidPhase::liquid);
    CHECK(phase_at(0.9, 0.920) == FluidPhase::supercooled_liquid);
    CHECK(phase_at(0.9, 1.000) == FluidPhase::solid);
}

TEST_CASE("above the critical temperature there is one fluid, until it freezes") {
    CHECK(phase_at(1.5, 0.01) == FluidPhase::supercritical);
    CHECK(phase_at(1.5, 0.31) == FluidPhase::supercritical);
    CHECK(phase_at(1.5, 0.9) == FluidPhase::supercritical);
    CHECK(phase_at(1.5, 1.2) == FluidPhase::solid);
    CHECK(phase_at(6.0, 1.2) == FluidPhase::supercritical);  // the freezing line is not known there
}

TEST_CASE("the lines of the phase diagram are named") {
    CHECK(phase_of_state(phased, 0.9, 0.8).lines() ==
          "saturated vapour 0.01446, saturated liquid 0.7528, freezing 0.898, melting 0.991");
    CHECK(phase_of_state(phased, 6.0, 0.8).lines().empty());
    for (const FluidPhase each : {FluidPhase::gas, FluidPhase::liquid, FluidPhase::supercritical, FluidPhase::solid}) {
        CHECK_FALSE(std::string(name_of(each)).empty());
    }
}
