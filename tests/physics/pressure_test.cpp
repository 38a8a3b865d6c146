// The virial pressure is -dU/dV, and its tensor the response to stretching one edge.
#include <cmath>
#include "catch.hpp"

#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

double energy_in(const State& state, const Vec3& stretch, const std::string& truncation) {
    State scaled = state;
    scaled.rescale_to(Box(state.box().edges().cwiseProduct(stretch)));
    auto force_field = test::lennard_jones(truncation, "cells");
    return force_field.evaluate(scaled, Request::forces_and_energy).potential_energy;
}

}  // namespace

TEST_CASE("the virial is the response of the energy to a change of the box") {
    for (const std::string truncation : {"force-shifted", "switched"}) {
        const State state = test::liquid(4, 9, truncation);
        State copy = state;
        auto force_field = test::lennard_jones(truncation);
        const Mat3 virial = force_field.evaluate(copy, Request::forces_and_energy).virial;
        constexpr double h = 2e-6;
        // dU/d(ln L_a) = -W_aa: each edge on its own, then all together: dU/d(ln V) = -trace(W)/3.
        Vec3 diagonal;
        for (int a = 0; a < 3; ++a) {
            const Vec3 up = Vec3::Ones() + h * Vec3::Unit(a);
            const Vec3 down = Vec3::Ones() - h * Vec3::Unit(a);
            diagonal[a] = -(energy_in(state, up, truncation) - energy_in(state, down, truncation)) / (2.0 * h);
        }
        const double scale = virial.diagonal().cwiseAbs().maxCoeff();
        INFO(truncation << ": " << virial.diagonal().transpose() << " against " << diagonal.transpose());
        CHECK((diagonal - virial.diagonal()).cwiseAbs().maxCoeff() < 1e-7 * scale);
        const Vec3 all = Vec3::Ones();
        const double trace =
            -(energy_in(state, (1.0 + h) * all, truncation) - energy_in(state, (1.0 - h) * all, truncation)) /
            (2.0 * h);
        CHECK(std::abs(trace - virial.trace()) < 1e-7 * scale);  // the trace itself may be near zero
        CHECK((virial - virial.transpose()).cwiseAbs().maxCoeff() < 1e-12 * scale);
    }
}
