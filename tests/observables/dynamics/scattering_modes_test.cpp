#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include "catch.hpp"

#include "observables/dynamics/scattering.hpp"
#include "scattering_box.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// A damped oscillator in a bath: <x(0) x(t)> = exp(-z t) (cos(w t) + z/w sin(w t)), <x^2> = 1.
class Oscillator {
  public:
    Oscillator(double damping, double frequency, double interval) {
        const double square = damping * damping + frequency * frequency;
        const double decay = std::exp(-damping * interval);
        const double c = decay * std::cos(frequency * interval);
        const double s = decay * std::sin(frequency * interval) / frequency;
        step_ << c + damping * s, s, -square * s, c - damping * s;
        const Eigen::Matrix2d stationary = Eigen::Vector2d(1.0, square).asDiagonal();
        noise_ = (stationary - step_ * stationary * step_.transpose()).llt().matrixL();
    }

    Eigen::Vector2d next(std::mt19937_64& generator) {
        std::normal_distribution<double> normal;
        const double first = normal(generator);
        now_ = step_ * now_ + noise_ * Eigen::Vector2d(first, normal(generator));
        return now_;
    }

  private:
    Eigen::Matrix2d step_;
    Eigen::Matrix2d noise_;
    Eigen::Vector2d now_{1.0, 0.0};
};

/// Atoms of a cubic lattice that fills the box.
Eigen::Matrix3Xd lattice(Index atoms_an_edge) {
    Eigen::Matrix3Xd positions(3, atoms_an_edge * atoms_an_edge * atoms_an_edge);
    for (Index i = 0; i < positions.cols(); ++i) {
        const Index n = atoms_an_edge;
        const Index row = i / n;
        const Index layer = row / n;
        positions.col(i) = edge / static_cast<double>(n) *
                           Vec3(static_cast<double>(i % n), static_cast<double>(row % n), static_cast<double>(layer));
    }
    return positions;
}

}  // namespace

TEST_CASE("frames made of known normal modes have their F, C_L, S(k, w), speed and attenuation of sound") {
    constexpr double damping = 0.5;
    constexpr double frequency = 4.0;
    constexpr double spacing = 0.1;
    constexpr Index lags = 60;
    constexpr double amplitude = 0.02;
    const Eigen::Matrix3Xd rest = lattice(4);
    const Index atoms = rest.cols();
    const double k = 2.0 * std::numbers::pi / edge;
    const auto shells = wave_shells(cube, k, k, 1, 3);
    Scattering scattering(atoms, density, shells, {1, lags, spacing}, 2 * lags, 2);
    std::array<Oscillator, 3> modes{Oscillator(damping, frequency, spacing), Oscillator(damping, frequency, spacing),
                                    Oscillator(damping, frequency, spacing)};
    std::mt19937_64 generator(5);
    for (Index frame = 0; frame < 2 * lags * 128; ++frame) {
        State state(atoms, cube);
        Eigen::Matrix3Xd r = rest;
        Eigen::Matrix3Xd v(3, atoms);
        for (Index axis = 0; axis < 3; ++axis) {
            const Eigen::Vector2d now = modes[static_cast<std::size_t>(axis)].next(generator);
            const Eigen::RowVectorXd wave = amplitude * (k * rest.row(axis).array()).cos();
            r.row(axis) += now[0] * wave;
            v.row(axis) = now[1] * wave;
        }
        state.write_positions() = r;
        state.write_velocities() = v;
        scattering.sample(state, Evaluation{});
    }
    const auto tables = scattering.tables();
    const auto n = static_cast<double>(atoms);
    const double size = 0.25 * n * k * k * amplitude * amplitude;
    const auto exact = [&](double t) {
        return size * std::exp(-damping * t) *
               (std::cos(frequency * t) + damping / frequency * std::sin(frequency * t));
    };
    const auto whole = table(tables, "fkt").rows;
    const double square = damping * damping + frequency * frequency;
    for (const auto& row : whole) {
        CHECK(std::abs(row[2] - exact(row[1])) < 4.5 * row[3] + 1e-3 * size);
        const double t = row[1];
        const double longitudinal = size * square * std::exp(-damping * t) *
                                    (std::cos(frequency * t) - damping / frequency * std::sin(frequency * t));
        CHECK(std::abs(row[4] - longitudinal) < 4.5 * row[5] + 1e-3 * size * square);
        CHECK(row[3] < 0.05 * size);
    }
    for (const auto& row : table(tables, "skw").rows) {
        double wanted = 0.0;
        for (Index lag = 0; lag <= lags; ++lag) {
            const double t = spacing * static_cast<double>(lag);
            const double weight = lag == 0 || lag == lags ? 0.5 : 1.0;
            wanted += weight * spacing * exact(t) *
                      std::pow(std::cos(0.5 * std::numbers::pi * t / (spacing * lags)), 2) * std::cos(row[1] * t) /
                      std::numbers::pi;
        }
        CHECK(std::abs(row[2] - wanted) < 4.5 * row[3] + 1e-3 * size);
    }
    const auto found = table(tables, "modes").rows.at(0);
    CHECK(std::abs(found[1] - frequency / k) < 4.0 * found[2]);
    CHECK(found[2] < 0.02 * found[1]);
    CHECK(std::abs(found[3] - damping / (k * k)) < 4.0 * found[4]);
    CHECK(found[4] < 0.1 * found[3]);
    CHECK(std::abs(found[7]) < 4.0 * found[8]);  // no atom leaves its place for good
    const auto results = scattering.observables();
    REQUIRE(results.size() == 1);
    CHECK(results[0].name == "sound_velocity");
    CHECK(results[0].estimate->mean == found[1]);
    CHECK(results[0].estimate->standard_error == found[2]);
}

TEST_CASE("atoms that stay where they are have the viscosity of the friction that their velocities feel") {
    // j_T decays as the velocities do, exp(-friction t), so that eta = rho friction/k^2.
    constexpr double friction = 1.5;
    constexpr double spacing = 0.05;
    constexpr Index lags = 80;
    const Eigen::Matrix3Xd rest = lattice(4);
    const Index atoms = rest.cols();
    const auto shells = wave_shells(cube, 0.7, 1.7, 2, 3);
    Scattering scattering(atoms, density, shells, {1, lags, spacing}, 2 * lags, 1);
    std::mt19937_64 generator(6);
    std::normal_distribution<double> normal;
    const double kept = std::exp(-friction * spacing);
    const auto normals = [&] {
        return Eigen::Matrix3Xd(Eigen::Matrix3Xd::NullaryExpr(3, atoms, [&] { return normal(generator); }));
    };
    Eigen::Matrix3Xd v = normals();
    for (Index frame = 0; frame < 2 * lags * 256; ++frame) {
        State state(atoms, cube);
        state.write_positions() = rest;
        state.write_velocities() = v;
        scattering.sample(state, Evaluation{});
        v = kept * v + std::sqrt(1.0 - kept * kept) * normals();
    }
    const auto tables = scattering.tables();
    for (const auto& row : table(tables, "modes").rows) {
        CHECK(std::isnan(row[1]));
        CHECK(std::abs(row[5] - density * friction / (row[0] * row[0])) < 4.0 * row[6] + 0.005 * row[5]);
        CHECK(row[6] < 0.1 * row[5]);
        CHECK(row[7] == 0.0);
    }
    const auto results = scattering.observables();
    REQUIRE(results.size() == 1);
    CHECK_FALSE(results[0].estimate);
    CHECK_THAT(results[0].remark, Catch::Contains("no side peak") && Catch::Contains("the smallest k, 0.785"));
}

TEST_CASE("random walks have their coefficient of diffusion at every wave number") {
    constexpr double diffusion = 0.3;
    constexpr double spacing = 0.05;
    constexpr Index atoms = 64;
    const auto shells = wave_shells(cube, 0.7, 2.0, 3, 3);
    Scattering scattering(atoms, density, shells, {1, 20, spacing}, 40, 2);
    std::mt19937_64 generator(7);
    std::normal_distribution<double> normal(0.0, std::sqrt(2.0 * diffusion * spacing));
    Eigen::Matrix3Xd r = lattice(4);
    for (Index frame = 0; frame < Index{40} * 200; ++frame) {
        if (frame == Index{20} * 30) {  // many origins, but they share frames: of 15 blocks there is no error
            const auto early = table(scattering.tables(), "modes").rows;
            CHECK(std::isnan(early.at(0)[7]));
            CHECK(std::isnan(early.at(0)[8]));
        }
        State state(atoms, cube);
        state.write_positions() = r;
        scattering.sample(state, Evaluation{});
        r += Eigen::Matrix3Xd::NullaryExpr(3, atoms, [&] { return normal(generator); });
    }
    const auto tables = scattering.tables();
    for (const auto& row : table(tables, "modes").rows) {
        CHECK(std::abs(row[7] - diffusion * (1.0 - 1.0 / atoms)) < 4.0 * row[8]);
        CHECK(row[8] < 0.05 * diffusion);
    }
}
