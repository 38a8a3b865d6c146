#include "engine/at_temperature.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

Estimate exact(double value, const Vec3&) {
    return {value, 0.0, 1.0, 1, true};
}

constexpr double density = 0.75;

}  // namespace

TEST_CASE("a fluid that follows the equation of state is brought to what that has at the other temperature") {
    const EquationOfState equation = equation_of_state("thol2016");
    const FluidProperties here = properties(equation, 0.97, density);
    const FluidProperties there = properties(equation, 1.0, density);
    const AtTemperature found =
        at_temperature(equation, density, 1.0, {0.97, here.potential_energy, here.pressure}, exact);
    CHECK(found.potential_energy.mean == Approx(there.potential_energy).epsilon(1e-13));
    CHECK(found.pressure.mean == Approx(there.pressure).epsilon(1e-12));
    CHECK(found.compressibility_factor.mean == Approx(there.compressibility_factor).epsilon(1e-12));
}

TEST_CASE("errors follow from the slopes of the values in the means") {
    const EquationOfState equation = equation_of_state("thol2016");
    const Vec3 means(0.97, -5.1, 0.4);
    const auto values = [&](const Vec3& at) { return at_temperature(equation, density, 1.0, at, exact); };
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        // The component of each gradient, in the place of the error.
        const AtTemperature found = at_temperature(equation, density, 1.0, means, [&](double value, const Vec3& g) {
            return Estimate{value, g[axis], 1.0, 1, true};
        });
        constexpr double h = 1e-4;
        const AtTemperature above = values(means + h * Vec3::Unit(axis));
        const AtTemperature below = values(means - h * Vec3::Unit(axis));
        const auto slope = [&](Estimate AtTemperature::*of) {
            return ((above.*of).mean - (below.*of).mean) / (2.0 * h);
        };
        for (Estimate AtTemperature::*of :
             {&AtTemperature::potential_energy, &AtTemperature::pressure, &AtTemperature::compressibility_factor}) {
            CHECK((found.*of).standard_error == Approx(slope(of)).epsilon(1e-6).margin(1e-9));
        }
    }
}
