#include "observables/transport/velocity_autocorrelation.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

constexpr LagTimes ten_lags{.every = 2, .count = 10, .spacing = 0.05};

enum Column : std::size_t { time_column, vacf_column, error_column, normalized_column, diffusion_column };

/// Velocities that forget what they were at the rate `friction`, in a bath of temperature 1 (Ornstein-Uhlenbeck): their
/// autocorrelation is 3 exp(-friction t), and 3 (1 - 1/N) exp(-friction t) about the centre of mass.
class Bath {
  public:
    Bath(Index atoms, double friction, double interval, unsigned seed)
        : kept_(std::exp(-friction * interval)),
          generator_(seed),
          state_(test::random_state(atoms, Box(Vec3::Constant(9.0)), 1)) {
        state_.write_velocities() = normals();
    }

    const State& next() {
        state_.write_velocities() = kept_ * state_.velocities() + std::sqrt(1.0 - kept_ * kept_) * normals();
        return state_;
    }

  private:
    Eigen::Matrix3Xd normals() {
        return Eigen::Matrix3Xd::NullaryExpr(3, state_.count(), [&] { return normal_(generator_); });
    }

    double kept_;
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    State state_;
};

State moving_state(Index atoms, unsigned seed) {
    State state = test::random_state(atoms, Box(Vec3::Constant(6.0)), seed);
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    state.write_velocities() = Eigen::Matrix3Xd::NullaryExpr(3, atoms, [&] { return normal(generator); });
    return state;
}

}  // namespace

TEST_CASE("the velocity autocorrelation follows atoms, wherever they lie in memory") {
    constexpr Index atoms = 40;
    constexpr Index window = 17;
    State state = moving_state(atoms, 3);
    std::mt19937_64 generator(5);
    VelocityAutocorrelation vacf(atoms, {{ten_lags, window}});
    CHECK(vacf.tables().empty());
    CHECK(vacf.observables().empty());
    std::vector<Eigen::Matrix3Xd> frames;
    for (Index t = 0; t < window; ++t) {
        std::vector<Index> order(atoms);
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), generator);
        state.reorder(order);
        state.write_velocities() = moving_state(atoms, 100 + static_cast<unsigned>(t)).velocities();
        const Eigen::Matrix3Xd v = test::by_id(state, state.velocities());
        frames.push_back(v.colwise() - v.rowwise().mean());
        vacf.sample(state, {});
    }
    CHECK(vacf.samples() == window);
    const DataTable table = vacf.tables().at(0);
    CHECK(table.name == "vacf");
    REQUIRE(table.rows.size() == 11);
    double integral = 0.0;
    double before = 0.0;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        double sum = 0.0;
        for (std::size_t t = 0; t + k < frames.size(); ++t) {
            sum += frames[t].cwiseProduct(frames[t + k]).sum();
        }
        const double expected = sum / static_cast<double>(atoms * (window - static_cast<Index>(k)));
        CHECK(table.rows[k][time_column] == Approx(0.05 * static_cast<double>(k)));
        CHECK(table.rows[k][vacf_column] == Approx(expected).margin(1e-13));
        CHECK(table.rows[k][normalized_column] == Approx(expected / table.rows[0][vacf_column]).margin(1e-13));
        integral += k == 0 ? 0.0 : 0.05 * 0.5 * (before + expected);
        before = expected;
        CHECK(table.rows[k][diffusion_column] == Approx(integral / 3.0).margin(1e-13));
    }
}

TEST_CASE("velocities that decay exponentially give the diffusion and the spectrum that belong to it") {
    constexpr double friction = 3.0;
    const LagTimes times{.every = 1, .count = 60, .spacing = 0.03};
    VelocityAutocorrelation vacf(200, {{times, 120}});
    Bath bath(200, friction, times.spacing, 11);
    for (int t = 0; t < 120 * 40; ++t) {
        vacf.sample(bath.next(), {});
    }
    const DataTable correlation = vacf.tables().at(0);
    constexpr double about_centre = 1.0 - 1.0 / 200.0;
    for (const auto& row : correlation.rows) {
        CHECK(std::abs(row[vacf_column] - 3.0 * about_centre * std::exp(-friction * row[time_column])) <
              4.0 * row[error_column]);
        CHECK(row[error_column] < 0.03);
    }
    const auto found = vacf.observables();
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "diffusion_green_kubo");
    const double until = about_centre * (1.0 - std::exp(-friction * 1.8));
    CHECK(std::abs(found[0].estimate->mean - until / friction) < 3.0 * found[0].estimate->standard_error);
    CHECK(found[0].estimate->standard_error < 0.01);

    const DataTable spectrum = vacf.tables().at(1);
    CHECK(spectrum.name == "vibrational_spectrum");
    const double step = std::numbers::pi / 1.8;
    double integral = 0.0;
    for (std::size_t k = 0; k < spectrum.rows.size(); ++k) {
        const double frequency = spectrum.rows[k][0];
        CHECK(frequency == Approx(step * static_cast<double>(k)));
        const double lorentzian = 2.0 / std::numbers::pi * friction / (friction * friction + frequency * frequency);
        CHECK(spectrum.rows[k][1] == Approx(lorentzian).margin(0.01));
        integral += step * spectrum.rows[k][1] * (k == 0 || k + 1 == spectrum.rows.size() ? 0.5 : 1.0);
    }
    CHECK(integral == Approx(1.0).epsilon(1e-12));
    CHECK(spectrum.rows[0][1] ==
          Approx(6.0 * found[0].estimate->mean / (std::numbers::pi * correlation.rows[0][vacf_column])).epsilon(1e-12));
}

TEST_CASE("configurations that are too far apart have no diffusion, and no spectrum") {
    // exp(-1.5) is left from one to the next: the trapezoidal rule gives 0.39 where 1/3 is right.
    constexpr double friction = 3.0;
    const LagTimes times{.every = 1, .count = 6, .spacing = 0.5};
    VelocityAutocorrelation vacf(200, {{times, 12}});
    Bath bath(200, friction, times.spacing, 11);
    for (int t = 0; t < 12 * 40; ++t) {
        vacf.sample(bath.next(), {});
    }
    const ObservableAverage found = vacf.observables().at(0);
    CHECK(found.name == "diffusion_green_kubo");
    CHECK_FALSE(found.estimate.has_value());
    CHECK_FALSE(found.remark.empty());
    const auto tables = vacf.tables();
    REQUIRE(tables.size() == 1);
    for (const auto& row : tables[0].rows) {
        CHECK(std::abs(row[vacf_column] - 3.0 * std::exp(-friction * row[time_column])) < 4.0 * row[error_column]);
        CHECK(std::isnan(row[diffusion_column]));
        CHECK(std::isnan(row[diffusion_column + 1]));
    }
}

TEST_CASE("an oscillation is a line in the spectrum") {
    const LagTimes times{.every = 1, .count = 100, .spacing = 0.05};
    VelocityAutocorrelation vacf(2, {{times, 200}});
    State state = test::random_state(2, Box(Vec3::Constant(5.0)), 1);
    const double frequency = 20.0 * std::numbers::pi / 5.0;  // ten periods in the largest time: a point of the table
    for (int t = 0; t < 400; ++t) {
        const double phase = frequency * 0.05 * t;
        auto v = state.write_velocities();
        v.col(0) = Vec3(std::cos(phase), std::sin(phase), 0.0);
        v.col(1) = -v.col(0);
        vacf.sample(state, {});
    }
    const DataTable spectrum = vacf.tables().at(1);
    for (std::size_t k = 0; k < spectrum.rows.size(); ++k) {
        CHECK(spectrum.rows[k][1] == Approx(k == 20 ? 5.0 / std::numbers::pi : 0.0).margin(1e-12));
    }
}

TEST_CASE("a frame that moves sees the same correlations, and a single atom has none") {
    const auto seen_from = [](const Vec3& velocity, Index atoms) {
        VelocityAutocorrelation vacf(atoms, {{ten_lags, 15}});
        Bath bath(atoms, 2.0, ten_lags.spacing, 12);
        for (int t = 0; t < 60; ++t) {
            State state = bath.next();
            state.write_velocities().colwise() += velocity * (1.0 + 0.1 * t);
            vacf.sample(state, {});
        }
        return vacf;
    };
    const VelocityAutocorrelation still = seen_from(Vec3::Zero(), 30);
    const VelocityAutocorrelation moving = seen_from(Vec3(5.0, -1.0, 0.3), 30);
    CHECK(moving.observables().at(0).estimate->mean == Approx(still.observables().at(0).estimate->mean).epsilon(1e-9));
    for (std::size_t k = 0; k < 11; ++k) {
        CHECK(moving.tables().at(0).rows[k][1] == Approx(still.tables().at(0).rows[k][1]).margin(1e-11));
    }
    const ObservableAverage alone = seen_from(Vec3::Zero(), 1).observables().at(0);
    CHECK_FALSE(alone.estimate.has_value());
    CHECK(alone.remark == "a single atom has no motion about the centre of mass");
}

TEST_CASE("a velocity autocorrelation goes on from an archive bit for bit, and drops what was interrupted") {
    const LagTimes twice{.every = 4, .count = 8, .spacing = 0.1};
    const std::vector<VelocityAutocorrelation::Level> levels{{ten_lags, 15}, {twice, 11}};
    const auto sampled = [&](int interrupted_at, int archived_at) {
        auto vacf = std::make_unique<VelocityAutocorrelation>(30, levels);
        Bath bath(30, 2.0, ten_lags.spacing, 12);
        for (int t = 0; t < 70; ++t) {
            if (t == interrupted_at) {
                vacf->interrupt();
            }
            if (t == archived_at) {
                auto restored = std::make_unique<VelocityAutocorrelation>(30, levels);
                test::through_archive(*vacf, *restored);
                vacf = std::move(restored);
            }
            vacf->sample(bath.next(), {});
        }
        CHECK(vacf->samples() == 70);
        std::vector<std::vector<double>> rows = vacf->tables().at(0).rows;
        for (std::size_t row = 11; row < rows.size(); ++row) {
            rows[row].resize(error_column);  // beyond, there are three windows, too few for an error, and no D
        }
        return rows;
    };
    const auto whole = sampled(-1, -1);
    CHECK(whole.size() == 11 + 3);
    CHECK(sampled(-1, 20) == whole);
    CHECK(sampled(-1, 21) == whole);  // with a velocity that waits for its partner
    CHECK(sampled(-1, 30) == whole);
    CHECK(sampled(31, -1) != whole);
}

TEST_CASE(
    "at long times velocities are averaged: an oscillation is weaker by what is known, and by less than a bound") {
    // Ten atoms at equally spaced phases: cos(w t) exactly, for any window, and their centre is at rest.
    constexpr Index atoms = 10;
    constexpr double w = 1.1;
    const LagTimes first{.every = 1, .count = 8, .spacing = 0.1};
    std::vector<VelocityAutocorrelation::Level> levels{{first, 16}};
    for (Index n = 1; n < 4; ++n) {
        const Index m = Index{1} << n;
        levels.push_back({{.every = m, .count = 8, .spacing = 0.1 * static_cast<double>(m)}, 16});
    }
    VelocityAutocorrelation vacf(atoms, levels);
    State state = test::random_state(atoms, Box(Vec3::Constant(5.0)), 1);
    for (int t = 0; t < 256; ++t) {
        auto v = state.write_velocities();
        for (Index i = 0; i < atoms; ++i) {
            const double phase = w * 0.1 * t + 2.0 * std::numbers::pi * static_cast<double>(i) / atoms;
            v.col(i) = Vec3(std::cos(phase), 0.0, std::sin(phase));
        }
        vacf.sample(state, {});
    }
    const auto rows = vacf.tables().at(0).rows;
    REQUIRE(rows.size() == 9 + 3 * 4);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double m = row < 9 ? 1.0 : std::pow(2.0, 1.0 + std::floor(static_cast<double>(row - 9) / 4.0));
        const double t = rows[row][time_column];
        const double half = 0.5 * w * 0.1;
        const double weaker = std::pow(std::sin(m * half) / (m * std::sin(half)), 2);
        CAPTURE(row, t, m);
        CHECK(rows[row][vacf_column] == Approx(weaker * std::cos(w * t)).margin(1e-12));
        CHECK(std::abs(rows[row][vacf_column] - std::cos(w * t)) <= (m * m - 1.0) * w * w * 0.01 / 12.0 + 1e-12);
        CHECK((row < 9 || std::isnan(rows[row][diffusion_column])));
    }
    CHECK(rows[9][time_column] == Approx(1.0));  // 5 times 0.2
    CHECK(rows.back()[time_column] == Approx(6.4));
}

TEST_CASE("mean velocities of a bath have its exponential function, within errors and the bound of their bias") {
    constexpr double friction = 0.3;
    const LagTimes first{.every = 1, .count = 10, .spacing = 0.1};
    std::vector<VelocityAutocorrelation::Level> levels;
    for (Index n = 0; n < 4; ++n) {
        const Index m = Index{1} << n;
        levels.push_back({{.every = m, .count = 10, .spacing = 0.1 * static_cast<double>(m)}, 20});
    }
    VelocityAutocorrelation vacf(400, levels);
    Bath bath(400, friction, first.spacing, 4);
    for (int t = 0; t < 8000; ++t) {
        vacf.sample(bath.next(), {});
    }
    const auto rows = vacf.tables().at(0).rows;
    REQUIRE(rows.size() == 11 + 3 * 5);
    CHECK(rows.back()[time_column] == Approx(8.0));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double m = row < 11 ? 1.0 : std::pow(2.0, 1.0 + std::floor(static_cast<double>(row - 11) / 5.0));
        const double c = 3.0 * (1.0 - 1.0 / 400.0) * std::exp(-friction * rows[row][time_column]);
        // C'' is friction^2 C, and a third more over the width of the average.
        const double bias = 4.0 / 3.0 * (m * m - 1.0) * 0.01 / 12.0 * friction * friction * c;
        CHECK(std::abs(rows[row][vacf_column] - c) < 4.5 * rows[row][error_column] + bias);
        CHECK(rows[row][error_column] < 0.02);
        CHECK(bias < 0.01 * c);
    }
}
