#include "observables/transport/stress_autocorrelation.hpp"

#include <cmath>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

const Box box(Vec3(4.0, 5.0, 6.0));

/// Two atoms with opposite velocities, of temperature (2/3) v^2, and the virial that makes their pressure tensor `p`.
Evaluation evaluation_for(const State& state, const Mat3& p) {
    Evaluation evaluation;
    evaluation.virial = p * box.volume();
    for (Index i = 0; i < state.count(); ++i) {
        evaluation.virial -= state.velocities().col(i) * state.velocities().col(i).transpose();
    }
    return evaluation;
}

State two_atoms(double speed) {
    State state = test::random_state(2, box, 1);
    auto v = state.write_velocities();
    v.col(0) = Vec3(0.6 * speed, 0.0, 0.8 * speed);
    v.col(1) = -v.col(0);
    return state;
}

/// Tensors whose six different components decay exponentially, with an isotropic part that must not count.
class Stress {
  public:
    Stress(double rate, double interval, unsigned seed) : kept_(std::exp(-rate * interval)), generator_(seed) {}

    Mat3 next() {
        Mat3 noise;
        noise = noise.NullaryExpr([&] { return normal_(generator_); });
        // For an isotropic fluid off-diagonal components have the variance 1, <P'_xx^2> = 4/3.
        const Mat3 symmetric = (noise + noise.transpose()) / std::sqrt(2.0);
        last_ = kept_ * last_ + std::sqrt(1.0 - kept_ * kept_) * symmetric;
        return last_ + normal_(generator_) * Mat3::Identity();
    }

  private:
    double kept_;
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    Mat3 last_ = Mat3::Zero();
};

}  // namespace

TEST_CASE("a constant shear stress gives its square, and a constant pressure nothing") {
    const LagTimes lags{.every = 5, .count = 4, .spacing = 0.1};
    Mat3 p = Mat3::Zero();
    double expected = 0.0;  // a tenth of the sum of squares of the traceless symmetric part
    SECTION("xy") {
        p(0, 1) = p(1, 0) = 2.0;
        expected = 0.8;
    }
    SECTION("xz of one side only") {
        p(0, 2) = 2.0;
        expected = 0.2;
    }
    SECTION("yz") {
        p(1, 2) = p(2, 1) = -1.0;
        expected = 0.2;
    }
    SECTION("xx against yy") {
        p.diagonal() = Vec3(1.0, -1.0, 0.0);
        expected = 0.2;
    }
    SECTION("zz alone") {
        p(2, 2) = 3.0;
        expected = 0.6;
    }
    SECTION("pressure") {
        p = 5.0 * Mat3::Identity();
    }
    StressAutocorrelation stress(box, lags, 9);
    CHECK(stress.needs_energy());
    const State state = two_atoms(1.5);
    for (int t = 0; t < 9; ++t) {
        CHECK(stress.tables().empty());
        CHECK(stress.observables().empty());
        stress.sample(state, evaluation_for(state, p));
    }
    const auto tables = stress.tables();
    REQUIRE(tables.size() == 1);
    CHECK(tables[0].name == "stress_autocorrelation");
    REQUIRE(tables[0].rows.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
        const double time = 0.1 * static_cast<double>(k);
        CHECK(tables[0].rows[k][0] == Approx(time));
        CHECK(tables[0].rows[k][1] == Approx(expected).margin(1e-12));
        CHECK(tables[0].rows[k][3] == Approx(120.0 / 1.5 * expected * time).margin(1e-11));  // T = 2 * 2.25/3
    }
    CHECK(stress.observables().at(0).name == "viscosity");
    CHECK(stress.observables().at(0).estimate->mean == Approx(120.0 / 1.5 * expected * 0.4).margin(1e-11));
}

TEST_CASE("atoms at rest, and what rounding leaves of it, have no viscosity, and it says why") {
    for (const double speed : {0.0, 1e-15}) {
        StressAutocorrelation stress(box, {.every = 5, .count = 4, .spacing = 0.1}, 9);
        const State state = two_atoms(speed);
        for (int t = 0; t < 9; ++t) {
            stress.sample(state, evaluation_for(state, Mat3::Constant(1e-14)));
        }
        CHECK_FALSE(stress.observables().at(0).estimate.has_value());
        CHECK_THAT(stress.observables().at(0).remark, Catch::Contains("divided by the temperature"));
        const DataTable table = stress.tables().at(0);
        CHECK(std::isfinite(table.rows[2][1]));
        CHECK(std::isnan(table.rows[2][3]));
    }
}

TEST_CASE("stresses that decay exponentially have the viscosity that belongs to it") {
    constexpr double rate = 2.0;
    const LagTimes lags{.every = 1, .count = 80, .spacing = 0.02};
    StressAutocorrelation viscosity(box, lags, 320);
    Stress stress(rate, lags.spacing, 7);
    for (int t = 0; t < 320 * 64; ++t) {
        const State state = two_atoms(t % 2 == 0 ? 1.0 : 2.0);  // T = 2/3 and 8/3: 5/3 in the mean
        viscosity.sample(state, evaluation_for(state, stress.next()));
    }
    const DataTable table = viscosity.tables().front();
    for (const auto& row : table.rows) {
        CHECK(std::abs(row[1] - std::exp(-rate * row[0])) < 4.0 * row[2]);
    }
    const Estimate found = viscosity.observables().front().estimate.value();
    const double expected = 120.0 / (5.0 / 3.0) * (1.0 - std::exp(-rate * 1.6)) / rate;
    CHECK(std::abs(found.mean - expected) < 3.0 * found.standard_error);
    CHECK(found.standard_error < 0.1 * expected);
}

TEST_CASE("configurations that are too far apart have no viscosity") {
    const LagTimes lags{.every = 1, .count = 6, .spacing = 1.0};
    StressAutocorrelation viscosity(box, lags, 12);
    Stress stress(2.0, lags.spacing, 7);
    for (int t = 0; t < 12 * 100; ++t) {
        const State state = two_atoms(1.0);
        viscosity.sample(state, evaluation_for(state, stress.next()));
    }
    const ObservableAverage found = viscosity.observables().at(0);
    CHECK(found.name == "viscosity");
    CHECK_FALSE(found.estimate.has_value());
    CHECK_FALSE(found.remark.empty());
    const DataTable table = viscosity.tables().at(0);
    for (const auto& row : table.rows) {
        CHECK(std::abs(row[1] - std::exp(-2.0 * row[0])) < 4.0 * row[2]);
        CHECK(std::isnan(row[3]));
        CHECK(std::isnan(row[4]));
    }
}

TEST_CASE("a stress autocorrelation goes on from an archive bit for bit, and drops what was interrupted") {
    const LagTimes lags{.every = 1, .count = 5, .spacing = 0.1};
    const auto sampled = [&lags](int interrupted_at, int archived_at) {
        auto viscosity = std::make_unique<StressAutocorrelation>(box, lags, 12);
        Stress stress(2.0, lags.spacing, 8);
        for (int t = 0; t < 60; ++t) {
            if (t == interrupted_at) {
                viscosity->interrupt();
            }
            if (t == archived_at) {
                auto restored = std::make_unique<StressAutocorrelation>(box, lags, 12);
                test::through_archive(*viscosity, *restored);
                viscosity = std::move(restored);
            }
            const State state = two_atoms(1.0 + 0.01 * t);
            viscosity->sample(state, evaluation_for(state, stress.next()));
        }
        CHECK(viscosity->samples() == 60);
        return viscosity->tables().at(0).rows;
    };
    const auto whole = sampled(-1, -1);
    CHECK(sampled(-1, 17) == whole);
    CHECK(sampled(-1, 24) == whole);
    CHECK(sampled(24, -1) == whole);
    CHECK(sampled(25, -1) != whole);
}
