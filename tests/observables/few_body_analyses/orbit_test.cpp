#include <numbers>

#include "observables/few_body_analyses/made_few_body_analysis.hpp"
#include "observables/kepler.hpp"

using namespace ljmd;

namespace {

constexpr double pi = std::numbers::pi;

/// A comet of mass 0.001 about a star of mass 1 that moves on steadily; the comet lies second in the deck.
class StarAndComet {
  public:
    /// @param reordered  the comet lies first in memory
    explicit StarAndComet(bool reordered) : state_(test::bodies_at({Vec3::Zero(), Vec3::Zero()}, {1.0, 0.001})) {
        if (reordered) {
            state_.reorder({1, 0});
        }
    }

    const State& at(double time) {
        const Vec3 drift(0.3, -0.2, 0.1);
        const kepler::Point comet = ellipse_.at(time);
        const auto index = state_.index_of();
        auto r = state_.write_positions();
        auto v = state_.write_velocities();
        r.col(index[0]) = drift * time;
        v.col(index[0]) = drift;
        r.col(index[1]) = drift * time + comet.r;
        v.col(index[1]) = drift + comet.v;
        state_.time = time;
        return state_;
    }

    [[nodiscard]] const kepler::Ellipse& ellipse() const { return ellipse_; }

  private:
    kepler::Ellipse ellipse_ = kepler::sample_ellipse();  // mu = 1.001 = G (1 + 0.001)
    State state_;
};

std::string remark(const FewBodyAnalysis& analysis, const std::string& name) {
    for (const Finding& finding : analysis.findings()) {
        if (finding.name == name) {
            return finding.remark;
        }
    }
    FAIL(name << " is not found");
    return "";
}

/// The orbit of a body in a field of mu = 1 by leapfrog, over three periods.
/// @param start  distance at the start, an apsis of an ellipse with semi-major axis 1
std::unique_ptr<FewBodyAnalysis> orbit_by_leapfrog(const test::MadeTarget& field, double start, int steps_per_period) {
    auto orbit = test::made_few_body_analysis("orbit", {{"body", 1}}, field.target);
    const double step = 2.0 * pi / steps_per_period;
    kepler::Leapfrog body({Vec3(start, 0.0, 0.0), Vec3(0.0, std::sqrt(2.0 / start - 1.0), 0.0)}, 1.0, step);
    State state = test::bodies_at({Vec3::Zero()}, {1.0});
    for (int n = 0; n <= 3 * steps_per_period; ++n) {
        state.time = n * step;
        state.write_positions().col(0) = body.now().r;
        state.write_velocities().col(0) = body.now().v;
        orbit->sample({state, std::nullopt});
        body.step();
    }
    return orbit;
}

const std::vector<std::string> elements{"specific_energy", "specific_angular_momentum",
                                        "semi_major_axis", "eccentricity",
                                        "kepler_period",   "argument_of_pericentre"};

}  // namespace

TEST_CASE("an orbit about another body has its elements, apsides and period, wherever bodies lie in memory") {
    const test::MadeTarget gravity(2, 3, "newtonian-gravity", {{"gravitational_constant", 1.0}});
    for (const bool reordered : {false, true}) {
        StarAndComet motion(reordered);
        const kepler::Ellipse& e = motion.ellipse();
        const auto orbit = test::made_few_body_analysis("orbit", {{"body", 2}, {"about", 1}}, gravity.target);
        for (int n = 0; n <= 400; ++n) {
            orbit->sample({motion.at(0.1 * n), std::nullopt});
        }
        CHECK(test::finding(*orbit, "period") == Approx(e.period()).epsilon(1e-6));
        CHECK(test::finding(*orbit, "precession") == Approx(0.0).margin(1e-5));
        CHECK(test::finding(*orbit, "first_pericentre") == Approx(e.a * (1.0 - e.e)).epsilon(1e-9));
        CHECK(test::finding(*orbit, "first_apocentre") == Approx(e.a * (1.0 + e.e)).epsilon(1e-6));
        for (const std::string when : {"_at_start", "_at_end"}) {
            CHECK(test::finding(*orbit, "specific_energy" + when) == Approx(-0.5 * e.mu / e.a).epsilon(1e-12));
            CHECK(test::finding(*orbit, "specific_angular_momentum" + when) == Approx(1.2).epsilon(1e-12));
            CHECK(test::finding(*orbit, "semi_major_axis" + when) == Approx(e.a).epsilon(1e-12));
            CHECK(test::finding(*orbit, "eccentricity" + when) == Approx(e.e).epsilon(1e-12));
            CHECK(test::finding(*orbit, "kepler_period" + when) == Approx(e.period()).epsilon(1e-12));
            CHECK(test::finding(*orbit, "argument_of_pericentre" + when) == Approx(0.0).margin(1e-12));
        }
        const auto table = orbit->table();
        REQUIRE(table.has_value());
        CHECK(table->name == "orbit");
        CHECK(table->columns == std::vector<std::string>{"apocentre", "time", "distance", "angle"});
        REQUIRE(table->rows.size() == 6);  // pericentre at the start, then by turns
        for (std::size_t k = 0; k < table->rows.size(); ++k) {
            CHECK(table->rows[k][0] == static_cast<double>(k % 2));
            CHECK(table->rows[k][1] == Approx(0.5 * static_cast<double>(k) * e.period()).margin(1e-4));
            CHECK(table->rows[k][3] == Approx(pi * static_cast<double>(k)).margin(1e-4));
        }
    }
}

TEST_CASE("elements at the start are those of the first sample, at the end those of the last") {
    const test::MadeTarget field(1, 2, "newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", 2.0}});
    const auto orbit = test::made_few_body_analysis("orbit", {{"body", 1}}, field.target);
    State state = test::bodies_at({Vec3(1.0, 0.0, 0.0)}, {7.0});
    for (const double speed : {std::sqrt(2.0), 1.5, 1.0}) {
        state.write_velocities().col(0) = Vec3(0.0, speed, 0.0);
        orbit->sample({state, std::nullopt});
        state.time += 1.0;
    }
    CHECK(test::finding(*orbit, "eccentricity_at_start") ==
          Approx(0.0).margin(1e-15));  // mu = G M, whatever its own mass
    CHECK(test::finding(*orbit, "eccentricity_at_end") == Approx(0.5).epsilon(1e-14));
    CHECK(test::finding(*orbit, "specific_energy_at_end") == Approx(0.5 - 2.0).epsilon(1e-14));
}

TEST_CASE("an orbit without an inverse-square attraction has apsides and no elements") {
    const std::vector<std::pair<std::string, test::Numbers>> fields{
        {"harmonic", {{"stiffness", 1.0}}},
        {"newtonian-gravity", {{"gravitational_constant", 1.0}}},  // no central mass
        {"newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", 1.0}, {"softening", 0.1}}}};
    for (const auto& [name, numbers] : fields) {
        INFO(name);
        const test::MadeTarget field(1, 2, name, numbers);
        const auto orbit = test::made_few_body_analysis("orbit", {{"body", 1}}, field.target);
        State state = test::bodies_at({Vec3::Zero()}, {1.0});
        for (int n = 0; n <= 200; ++n) {  // an ellipse of half axes 2 and 1 about its middle
            const double t = 0.1 * n;
            state.write_positions().col(0) = Vec3(2.0 * std::cos(t), std::sin(t), 0.0);
            state.write_velocities().col(0) = Vec3(-2.0 * std::sin(t), std::cos(t), 0.0);
            state.time = t;
            orbit->sample({state, std::nullopt});
        }
        CHECK(test::finding(*orbit, "period") == Approx(pi).epsilon(1e-5));
        CHECK(test::finding(*orbit, "precession") == Approx(-pi).epsilon(1e-4));
        CHECK(test::finding(*orbit, "first_pericentre") == Approx(1.0).epsilon(1e-5));
        CHECK_FALSE(test::has_finding(*orbit, "eccentricity_at_start"));
        CHECK_FALSE(test::has_finding(*orbit, "eccentricity_at_end"));
    }
}

TEST_CASE("a radial orbit has the angle that it is given") {
    const test::MadeTarget radial(1, 1, "radial-kepler",
                                  {{"gravitational_parameter", 1.001}, {"angular_momentum", 1.2}});
    const auto orbit = test::made_few_body_analysis("orbit", {{"body", 1}}, radial.target);
    State state = test::bodies_at({Vec3::Zero()}, {1.0});
    for (int n = 0; n <= 200; ++n) {  // a swing between 1 and 3 of period 2 pi, turned on by 2 pi + 0.5 in each
        const double t = 0.1 * n;
        state.write_positions()(0, 0) = 2.0 - std::cos(t);
        state.write_velocities()(0, 0) = std::sin(t);
        state.time = t;
        const double rate = 1.0 + 0.25 / pi;
        orbit->sample({state, PolarAngle{rate * t, rate}});
    }
    CHECK(test::finding(*orbit, "period") == Approx(2.0 * pi).epsilon(1e-5));
    CHECK(test::finding(*orbit, "precession") == Approx(0.5).epsilon(1e-4));
    CHECK(test::finding(*orbit, "first_pericentre") == Approx(1.0).epsilon(1e-12));
    CHECK(test::finding(*orbit, "first_apocentre") == Approx(3.0).epsilon(1e-6));
    CHECK_FALSE(test::has_finding(*orbit, "eccentricity_at_end"));
}

TEST_CASE("an orbit has no values from an encounter on that steps do not resolve, but a remark") {
    const test::MadeTarget field(1, 2, "newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", 1.0}});
    const auto from_afar = orbit_by_leapfrog(field, 1.9, 100);
    for (const std::string name : {"period", "precession", "first_pericentre"}) {
        CHECK(test::has_finding(*from_afar, name));
        CHECK(std::isnan(test::finding(*from_afar, name)));
        CHECK_THAT(remark(*from_afar, name),
                   Catch::Contains("body 1 and the centre meet at time 3.1") && Catch::Contains("take smaller steps"));
    }
    CHECK(test::finding(*from_afar, "first_apocentre") == 1.9);
    CHECK(from_afar->table()->rows.size() == 1);  // the apocentre at the start
    const auto from_near = orbit_by_leapfrog(field, 0.1, 100);
    CHECK(test::has_finding(*from_near, "first_pericentre"));
    CHECK_THAT(remark(*from_near, "first_pericentre"), Catch::Contains("at time 0 within a step"));
    CHECK(from_near->table()->rows.empty());
    for (const auto& orbit : {from_afar.get(), from_near.get()}) {
        for (const std::string& name : elements) {
            CHECK(std::isfinite(test::finding(*orbit, name + "_at_start")));
            CHECK(remark(*orbit, name + "_at_start").empty());
            CHECK(std::isnan(test::finding(*orbit, name + "_at_end")));
            CHECK_FALSE(remark(*orbit, name + "_at_end").empty());
        }
    }
}

TEST_CASE("an orbit of two that are alone says what the time step has changed") {
    const test::MadeTarget field(1, 2, "newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", 1.0}});
    const auto orbit = orbit_by_leapfrog(field, 0.1, 1000);
    CHECK(test::finding(*orbit, "period") > 1.1 * test::finding(*orbit, "kepler_period_at_start"));
    for (const std::string name : {"period", "precession", "first_apocentre", "semi_major_axis_at_end"}) {
        CHECK(std::isfinite(test::finding(*orbit, name)));
        CHECK_THAT(remark(*orbit, name), Catch::Contains("the error of the time step"));
    }
    CHECK(remark(*orbit, "first_pericentre").empty());
    CHECK(test::finding(*orbit, "first_pericentre") == 0.1);
}

TEST_CASE("an orbit has no values after an encounter of others that steps do not resolve") {
    const test::MadeTarget gravity(3, 3, "newtonian-gravity", {{"gravitational_constant", 1.0}});
    const auto orbit = test::made_few_body_analysis("orbit", {{"body", 2}, {"about", 1}}, gravity.target);
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    State state = test::bodies_at({Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {1.0, 0.001, 0.001});
    for (int n = 0; n <= 400; ++n) {  // the third passes the first, at a distance of 0.01 when t = 20.05
        state.time = 0.1 * n;
        const kepler::Point comet = ellipse.at(state.time);
        state.write_positions().col(1) = comet.r;
        state.write_velocities().col(1) = comet.v;
        state.write_positions().col(2) = Vec3(state.time - 20.05, 0.01, 0.0);
        state.write_velocities().col(2) = Vec3(1.0, 0.0, 0.0);
        orbit->sample({state, std::nullopt});
    }
    CHECK_THAT(remark(*orbit, "period"), Catch::Contains("bodies 1 and 3 meet at time 20.05"));
    CHECK(std::isnan(test::finding(*orbit, "period")));
    CHECK(std::isnan(test::finding(*orbit, "eccentricity_at_end")));
    CHECK(test::finding(*orbit, "first_apocentre") == Approx(ellipse.a * (1.0 + ellipse.e)).epsilon(1e-6));
    CHECK(orbit->table()->rows.size() == 3);  // at 0, 7.46, 14.9
}

TEST_CASE("bodies at one place, or nowhere, have no elements then") {
    const test::MadeTarget field(1, 2, "newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", 2.0}});
    const auto orbit = test::made_few_body_analysis("orbit", {{"body", 1}}, field.target);
    State state = test::bodies_at({Vec3::Zero()}, {1.0});
    state.write_velocities().col(0) = Vec3(0.0, 1.0, 0.0);
    const auto sample_at = [&](double x) {
        state.write_positions().col(0) = Vec3(x, 0.0, 0.0);
        orbit->sample({state, std::nullopt});
        state.time += 1.0;
    };
    sample_at(0.0);
    CHECK_FALSE(test::has_finding(*orbit, "specific_energy_at_start"));
    sample_at(1.0);
    sample_at(2.0);
    sample_at(0.0);
    sample_at(std::nan(""));
    CHECK(test::finding(*orbit, "specific_energy_at_start") == 0.5 - 2.0);
    CHECK(test::finding(*orbit, "specific_energy_at_end") == 0.5 - 1.0);
}

TEST_CASE("what an orbit has not shown yet is left out") {
    const test::MadeTarget gravity(2, 3, "newtonian-gravity", {{"gravitational_constant", 1.0}});
    const auto orbit = test::made_few_body_analysis("orbit", {{"body", 2}, {"about", 1}}, gravity.target);
    CHECK(orbit->findings().empty());
    CHECK(orbit->table()->rows.empty());
    StarAndComet motion(false);
    orbit->sample({motion.at(1.0), std::nullopt});
    orbit->sample({motion.at(1.1), std::nullopt});
    CHECK_FALSE(test::has_finding(*orbit, "period"));
    CHECK_FALSE(test::has_finding(*orbit, "first_pericentre"));
    CHECK(test::has_finding(*orbit, "eccentricity_at_end"));
}

TEST_CASE("orbits of bodies that are not there, about themselves, or of distances about others are mistakes") {
    using Keys = std::vector<std::string>;
    const test::MadeTarget two(2, 2, "newtonian-gravity", {{"gravitational_constant", 1.0}});
    CHECK(test::faults("orbit", {{"body", 2}}, two.target).empty());
    CHECK(test::faults("orbit", {{"body", 2}, {"about", 1}}, two.target).empty());
    CHECK(test::faults("orbit", {{"body", 3}}, two.target) == Keys{"body"});
    CHECK(test::faults("orbit", {{"body", 1}, {"about", 3}}, two.target) == Keys{"about"});
    CHECK(test::faults("orbit", {{"body", 2}, {"about", 2}}, two.target) == Keys{"about"});
    const test::MadeTarget radial(2, 1, "radial-kepler", {{"gravitational_parameter", 1.0}, {"angular_momentum", 1.0}});
    CHECK(test::faults("orbit", {{"body", 1}}, radial.target).empty());
    CHECK(test::faults("orbit", {{"body", 2}}, radial.target) == Keys{"body"});
    CHECK(test::faults("orbit", {{"body", 1}, {"about", 2}}, radial.target) == Keys{"about"});
}
