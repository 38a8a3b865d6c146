#include "judge/net_force.hpp"

#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::StartsWith;

namespace {

const std::vector<Vec3> right{Vec3(1.0, -2.0, 0.5), Vec3(-3.0, 1.0, 0.0), Vec3(2.0, 1.0, -0.5)};
constexpr double noise = 1e-10;

std::string said(std::vector<Vec3> forces, const std::vector<Vec3>& more) {
    for (std::size_t i = 0; i < forces.size(); ++i) {
        forces[i] += more[i];
    }
    return net_force(forces, right, noise).value_or("");
}

}  // namespace

TEST_CASE("the same force on every atom is told from a net force, and both from forces that sum to zero") {
    const Vec3 none = Vec3::Zero();
    const Vec3 c(0.25, 0.0, -0.5);
    CHECK(said(right, {none, none, none}).empty());
    CHECK_THAT(said(right, {c, c, c}), StartsWith("constant force: the same force of (0.25, 0, -0.5) is added"));
    const Vec3 down(0.0, 0.0, -1e-6);
    CHECK_THAT(said(right, {down, down, down}), StartsWith("constant force: the same force of -1e-06 along z"));
    CHECK_THAT(said(right, {c, none, none}),
               StartsWith("net force: forces do not sum to zero, their sum is (0.25, 0, -0.5)"));
    CHECK(said(right, {c, -c, none}).empty());
}

TEST_CASE("rounding errors of single precision are no net force") {
    CHECK(said(right, {Vec3(1e-7, 0.0, 0.0), Vec3(0.0, 2e-7, 0.0), Vec3(0.0, 0.0, 1e-7)}).empty());
    CHECK(said(right, {Vec3(1e-11, 0.0, 0.0), Vec3(1e-11, 0.0, 0.0), Vec3(1e-11, 0.0, 0.0)}).empty());
}
