#include "observables/transport/finite_size.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

using namespace ljmd;

namespace {

ObservableAverage average(const std::string& name, double mean, double error, bool converged = true) {
    return {name, "", "", Estimate{mean, error, 100.0, 100, converged}};
}

const Box cube(Vec3::Constant(8.0));

}  // namespace

TEST_CASE("diffusion is corrected by what temperature, viscosity and box say") {
    const auto found = diffusion_in_infinite_system(
        {average("temperature", 1.5, 0.1), average("diffusion", 0.03, 0.002), average("viscosity", 2.5, 0.5)}, cube);
    REQUIRE(found.has_value());
    const double correction = 2.837297 * 1.5 / (6.0 * std::numbers::pi * 2.5 * 8.0);
    CHECK(found->name == "diffusion_infinite_system");
    CHECK(found->unit == "sigma^2/tau");
    CHECK(found->estimate->mean == Approx(0.03 + correction));
    CHECK(found->estimate->standard_error == Approx(std::hypot(0.002, 0.2 * correction)));
    CHECK(found->estimate->converged);
}

TEST_CASE("the correction is as sure as what it is made of, and needs all of it and a cube") {
    const auto temperature = average("temperature", 1.5, 0.1);
    const auto diffusion = average("diffusion", 0.03, 0.002);
    const auto viscosity = average("viscosity", 2.5, 0.5, false);
    CHECK_FALSE(diffusion_in_infinite_system({temperature, diffusion, viscosity}, cube)->estimate->converged);
    CHECK_FALSE(diffusion_in_infinite_system({temperature, diffusion}, cube).has_value());
    CHECK_FALSE(diffusion_in_infinite_system({temperature, viscosity}, cube).has_value());
    CHECK_FALSE(diffusion_in_infinite_system({diffusion, viscosity}, cube).has_value());
    CHECK_FALSE(
        diffusion_in_infinite_system({temperature, diffusion, viscosity}, Box(Vec3(8.0, 8.0, 8.1))).has_value());
}

TEST_CASE("without a viscosity above zero the correction has no value, and it says why") {
    const auto temperature = average("temperature", 1.5, 0.1);
    const auto diffusion = average("diffusion", 0.03, 0.002);
    const ObservableAverage unknown{"viscosity", "", "", std::nullopt, "atoms at rest"};
    for (const ObservableAverage& viscosity :
         {unknown, average("viscosity", 0.0, 0.5), average("viscosity", -2.5, 3.0)}) {
        const auto found = diffusion_in_infinite_system({temperature, diffusion, viscosity}, cube);
        REQUIRE(found.has_value());
        CHECK_FALSE(found->estimate.has_value());
        CHECK_FALSE(found->remark.empty());
    }
}
