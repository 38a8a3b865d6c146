#include "analyze/evaluated_frame.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

const std::string nist = LJMD_TEST_DATA "/nist/lj_sample_config_periodic4.txt";

FluidSpec cut(double cutoff, bool tail = false) {
    FluidSpec spec;
    spec.potential = PairPotential::lennard_jones("cut", {cutoff, 0.0});
    spec.tail = tail;
    return spec;
}

Frame two_atoms() {
    Frame frame;
    frame.configuration.edges = Vec3(8.0, 8.0, 8.0);
    frame.configuration.positions = {Vec3(0.3, 4.0, 4.0), Vec3(7.1, 4.0, 4.0)};
    return frame;
}

}  // namespace

TEST_CASE("a frame without velocities has the virial part of the pressure, and says so") {
    Frame frame = two_atoms();
    const FluidSpec spec = cut(2.5);
    const EvaluatedFrame rest = evaluate_frame(frame, 1, spec, {}, "two");
    const double force = 24.0 * (2.0 * std::pow(1.2, -13) - std::pow(1.2, -7));
    CHECK(rest.virial(0, 0) == Approx(1.2 * force).epsilon(1e-12));
    CHECK(rest.virial_pressure == Approx(1.2 * force / (3.0 * 512.0)).epsilon(1e-12));
    const Document said = frame_document(rest, spec, "two");
    CHECK(said.data["pressure"].number() == rest.virial_pressure);
    CHECK(said.data["pressure_parts"].text() == "virial");
    CHECK(said.data["temperature"].is_null());
    CHECK_THAT(said.text, Contains("no velocities"));
    CHECK(rest.energies[0] == rest.energies[1]);

    frame.configuration.velocities = {Vec3(1.0, 0.0, 0.0), Vec3(-1.0, 0.0, 0.0)};
    const EvaluatedFrame moving = evaluate_frame(frame, 1, spec, {}, "two");
    const Document more = frame_document(moving, spec, "two");
    CHECK(more.data["temperature"].number() == Approx(2.0 / 3.0));  // 2 K = 2 in three degrees of freedom
    CHECK(more.data["pressure"].number() == Approx(rest.virial_pressure + 2.0 / 512.0 * 2.0 / 3.0));
    CHECK(more.data["remarks"].empty());
}

TEST_CASE("a tail is in energy and pressure, and in nothing else") {
    const EvaluatedFrame without = evaluate_frame(two_atoms(), 1, cut(2.5), {}, "two");
    const EvaluatedFrame with = evaluate_frame(two_atoms(), 1, cut(2.5, true), {}, "two");
    CHECK(with.found.potential_energy == without.found.potential_energy + with.tail_energy);
    CHECK(with.virial_pressure == Approx(without.virial_pressure + with.tail_pressure).epsilon(1e-12));
    CHECK(with.tail_energy < 0.0);
    CHECK(with.virial == without.virial);
    CHECK(with.energies == without.energies);
}

TEST_CASE("a frame that cannot be evaluated is refused with its number") {
    CHECK_THROWS_WITH(evaluate_frame(two_atoms(), 7, cut(4.5), {}, "two"),
                      Contains("frame 7") && Contains("half the box"));
    Frame same = two_atoms();
    same.configuration.positions[1] = same.configuration.positions[0];
    CHECK_THROWS_WITH(evaluate_frame(same, 7, cut(2.5), {}, "two"), Contains("frame 7") && Contains("overlap"));
    CHECK_THROWS_AS(evaluate_frame(same, 7, cut(2.5), {}, "two"), DataError);
}

TEST_CASE("formats of one configuration are read as one frame") {
    const auto reader = open_frames(nist, std::nullopt, "", "");
    Frame frame;
    REQUIRE(reader->next(frame));
    CHECK(frame.configuration.positions.size() == 30);
    CHECK_FALSE(reader->next(frame));
    CHECK_THROWS_AS(open_frames(nist, std::nullopt, "all", ""), InputError);
    CHECK_THROWS_AS(open_frames(nist + ".none", std::nullopt, "", ""), DataError);
}

TEST_CASE("an interaction is told in words, with all that changes energies") {
    CHECK(interaction_in_words(cut(2.5, true)) ==
          "lennard-jones, truncation 'cut', cutoff 2.5 sigma, with tail corrections");
    FluidSpec morse;
    morse.potential = PairPotential::make("morse", "switched", {.radius = 3.0, .switch_start = 2.5},
                                          {{"well_depth", 1.0}, {"steepness", 6.0}, {"minimum", 1.12}});
    CHECK(interaction_in_words(morse) ==
          "morse well_depth = 1, steepness = 6, minimum = 1.12, truncation 'switched', cutoff 3 sigma, switched from "
          "2.5, with tail corrections");
}
