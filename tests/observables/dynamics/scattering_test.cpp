#include "observables/dynamics/scattering.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include "catch.hpp"

#include "ideal_gas.hpp"
#include "scattering_box.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// Rows of a table with this wave number.
std::vector<std::vector<double>> rows_of(const DataTable& table, double k) {
    std::vector<std::vector<double>> found;
    for (const auto& row : table.rows) {
        if (row[0] == k) {
            found.push_back(row);
        }
    }
    return found;
}

}  // namespace

TEST_CASE("the self part of an ideal gas is that of a normal distribution") {
    // F_s = exp(-k^2 T (1 - 1/N) t^2/2): velocities never change, so that each start is one sample.
    constexpr Index atoms = 64;
    const auto shells = wave_shells(cube, 0.7, 3.0, 3, 3);
    Scattering scattering(atoms, density, shells, {1, 8, 0.1}, 9, 1);
    sample_ideal_gas(scattering, atoms, edge, 400, 9, 0.1);
    const auto tables = scattering.tables();
    for (const WaveShell& shell : shells) {
        const auto rows = rows_of(table(tables, "fskt"), shell.k);
        REQUIRE(rows.size() == 9);
        CHECK(rows[0][2] == 1.0);
        for (std::size_t lag = 1; lag < rows.size(); ++lag) {
            double wanted = 0.0;
            for (const WaveVector& v : shell.vectors) {
                wanted += std::exp(-0.5 * std::pow(v.length * rows[lag][1], 2) * (1.0 - 1.0 / atoms));
            }
            wanted /= static_cast<double>(shell.vectors.size());
            CHECK(std::abs(rows[lag][2] - wanted) < 5.0 * rows[lag][3]);
            CHECK(rows[lag][3] < 0.02);
        }
    }
}

TEST_CASE("currents begin with k^2 T, less what the fixed centre of mass takes") {
    constexpr Index atoms = 64;
    const auto shells = wave_shells(cube, 0.7, 3.0, 3, 3);
    Scattering scattering(atoms, density, shells, {1, 4, 0.05}, 5, 1);
    sample_ideal_gas(scattering, atoms, edge, 600, 5, 0.05);
    for (const WaveShell& shell : shells) {
        const auto rows = rows_of(table(scattering.tables(), "fkt"), shell.k);
        const double structure = rows[0][2];
        double k2 = 0.0;
        for (const WaveVector& v : shell.vectors) {
            k2 += v.length * v.length / static_cast<double>(shell.vectors.size());
        }
        const double wanted = k2 * (1.0 - structure / atoms);
        CHECK(std::abs(rows[0][4] - wanted) < 5.0 * rows[0][5]);
        CHECK(std::abs(rows[0][6] - wanted) < 5.0 * rows[0][7]);
        CHECK(rows[0][5] < 0.1 * wanted);
    }
}

TEST_CASE("scattering functions are the sums that define them") {
    // Atoms on their own ways, in three windows of 7 frames; compared with the formulas, term by term.
    constexpr Index atoms = 5;
    constexpr Index frames = 21;
    constexpr Index window = 7;
    constexpr Index lags = 4;
    constexpr double spacing = 0.3;
    const auto shells = wave_shells(cube, 0.8, 2.5, 3, 4);
    const auto position = [](Index i, double t) {
        const auto p = static_cast<double>(i + 1);
        return Vec3(edge * 0.13 * p + std::sin(t * p), 0.5 * t * p + std::cos(p * p), 1.7 * p - 0.9 * t);
    };
    const auto velocity = [](Index i, double t) {
        const auto p = static_cast<double>(i + 1);
        return Vec3(p * std::cos(t * p), 0.5 * p, -0.9 + 0.1 * p * t);
    };
    Scattering scattering(atoms, density, shells, {1, lags, spacing}, window, 2);
    std::vector<Eigen::Matrix3Xd> r;
    std::vector<Eigen::Matrix3Xd> v;
    for (Index frame = 0; frame < frames; ++frame) {
        Eigen::Matrix3Xd r_now(3, atoms);
        Eigen::Matrix3Xd v_now(3, atoms);
        for (Index i = 0; i < atoms; ++i) {
            r_now.col(i) = position(i, spacing * static_cast<double>(frame));
            v_now.col(i) = velocity(i, spacing * static_cast<double>(frame));
        }
        State state(atoms, cube);
        state.write_positions() = r_now;
        state.write_velocities() = v_now;
        scattering.sample(state, Evaluation{});
        r.emplace_back(r_now.colwise() - Vec3(r_now.rowwise().mean()));
        v.emplace_back(v_now.colwise() - Vec3(v_now.rowwise().mean()));
    }
    using Complex = std::complex<double>;
    const auto phase = [&](const WaveVector& k, Index frame, Index i) {
        return std::exp(Complex(0.0, -k.k.dot(r[static_cast<std::size_t>(frame)].col(i))));
    };
    const auto tables = scattering.tables();
    for (const WaveShell& shell : shells) {
        const auto whole = rows_of(table(tables, "fkt"), shell.k);
        const auto self = rows_of(table(tables, "fskt"), shell.k);
        const auto spectrum = rows_of(table(tables, "skw"), shell.k);
        const double count = static_cast<double>(shell.vectors.size()) * atoms;
        std::vector<double> f_of_lags;
        for (Index lag = 0; lag <= lags; ++lag) {
            double f = 0.0;
            double along = 0.0;
            double all = 0.0;
            Index pairs = 0;
            for (Index first = 0; first < frames; ++first) {
                if (first % window + lag >= window) {
                    continue;  // another window
                }
                ++pairs;
                for (const WaveVector& k : shell.vectors) {
                    Complex rho_0;
                    Complex rho_t;
                    Eigen::Vector3cd j_0 = Eigen::Vector3cd::Zero();
                    Eigen::Vector3cd j_t = Eigen::Vector3cd::Zero();
                    for (Index i = 0; i < atoms; ++i) {
                        const Complex then = phase(k, first, i);
                        const Complex now = phase(k, first + lag, i);
                        rho_0 += then;
                        rho_t += now;
                        j_0 += then * v[static_cast<std::size_t>(first)].col(i).cast<Complex>();
                        j_t += now * v[static_cast<std::size_t>(first + lag)].col(i).cast<Complex>();
                    }
                    f += (rho_t * std::conj(rho_0)).real() / count;
                    const Eigen::Vector3cd unit = (k.k / k.length).cast<Complex>();
                    const Complex l_0 = unit.cwiseProduct(j_0).sum();
                    const Complex l_t = unit.cwiseProduct(j_t).sum();
                    along += k.length * k.length * (l_t * std::conj(l_0)).real() / count;
                    all += k.length * k.length * j_t.cwiseProduct(j_0.conjugate()).sum().real() / count;
                }
            }
            const auto row = static_cast<std::size_t>(lag);
            const auto n = static_cast<double>(pairs);
            f_of_lags.push_back(f / n);
            CHECK(whole[row][1] == Approx(spacing * static_cast<double>(lag)));
            CHECK(whole[row][2] == Approx(f / n).margin(1e-12));
            CHECK(whole[row][4] == Approx(along / n).margin(1e-11));
            CHECK(whole[row][6] == Approx(0.5 * (all - along) / n).margin(1e-11));
            // Of the self part origins are at every second frame, and those are known that have all times.
            double f_s = 0.0;
            Index origins = 0;
            for (Index first = 0; first + lags < frames; first += 2) {
                ++origins;
                for (const WaveVector& k : shell.vectors) {
                    for (Index i = 0; i < atoms; ++i) {
                        f_s += (phase(k, first + lag, i) * std::conj(phase(k, first, i))).real() / count;
                    }
                }
            }
            CHECK(self[row][2] == Approx(f_s / static_cast<double>(origins)).margin(1e-12));
        }
        for (std::size_t n = 0; n < spectrum.size(); ++n) {
            const double w = std::numbers::pi * static_cast<double>(n) / (spacing * lags);
            CHECK(spectrum[n][1] == Approx(w));
            double integral = 0.0;
            for (Index lag = 0; lag <= lags; ++lag) {
                const double t = spacing * static_cast<double>(lag);
                const double weight = lag == 0 || lag == lags ? 0.5 : 1.0;
                const double hann = std::pow(std::cos(0.5 * std::numbers::pi * t / (spacing * lags)), 2);
                integral += weight * spacing * f_of_lags[static_cast<std::size_t>(lag)] * hann * std::cos(w * t);
            }
            CHECK(spectrum[n][2] == Approx(integral / std::numbers::pi).margin(1e-12));
        }
    }
}
