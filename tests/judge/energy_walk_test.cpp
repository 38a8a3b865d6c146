#include "judge/energy_walk.hpp"

#include <cmath>
#include <random>
#include "catch.hpp"

using namespace ljmd;

namespace {

/// Normal numbers, the same everywhere but for rounding.
class Normal {
  public:
    explicit Normal(unsigned seed) : source_(seed) {}
    double operator()() {
        return std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * 3.141592653589793 * uniform());
    }

  private:
    double uniform() { return static_cast<double>(source_() >> 11U) * 0x1p-53; }
    std::mt19937_64 source_;
};

constexpr int rows = 2048;
constexpr int series = 200;

/// A series at a large energy: noise, and steps of a walk.
std::vector<double> made_energy(Normal& normal, double noise, double step, double slope = 0.0) {
    std::vector<double> energy;
    double walked = 0.0;
    for (int k = 0; k < rows; ++k) {
        walked += step * normal();
        energy.push_back(-600.0 + noise * normal() + walked + slope * k / rows);
    }
    return energy;
}

}  // namespace

TEST_CASE("the walk of an energy has the variance of its mean, and noise is no walk") {
    Normal normal(1);
    double squares = 0.0;   // of the mean from where the walk began
    double slopes = 0.0;    // squared
    double found = 0.0;     // dE^2
    double of_noise = 0.0;  // dE^2, where there is no walk
    double noise_of_mean = 0.0;
    for (int k = 0; k < series; ++k) {
        const EnergyWalk walk = energy_walk(made_energy(normal, 0.1, 0.01));
        squares += std::pow(walk.mean + 600.0, 2) / series;
        slopes += walk.slope * walk.slope / series;
        found += walk.walk.value / series;
        const EnergyWalk noise = energy_walk(made_energy(normal, 0.1, 0.0));
        of_noise += noise.walk.value / series;
        noise_of_mean += noise.of_mean.value / series;
        CHECK(noise.jitter == Approx(0.1 * std::sqrt(2.0)).epsilon(0.1));
    }
    const double right = 1e-4 * rows / 3.0;
    CHECK(found == Approx(right).epsilon(0.1));
    CHECK(squares == Approx(right).epsilon(0.3));
    CHECK(slopes == Approx(3.6 * right).epsilon(0.3));
    CHECK(noise_of_mean == Approx(0.01 / rows).epsilon(0.05));
    CHECK(of_noise < 100.0 * noise_of_mean);
    CHECK(of_noise < 0.01 * right);
}

TEST_CASE("a steady drift is a slope, and hardly a walk: it excuses nothing") {
    Normal normal(2);
    const EnergyWalk walk = energy_walk(made_energy(normal, 0.01, 0.0, 8.0));
    CHECK(walk.slope == Approx(8.0).epsilon(1e-2));
    CHECK(walk.mean == Approx(-596.0).epsilon(1e-4));
    // Where the mean is off by 4, a walk of 8/(2 16)^(1/2) is seen.
    CHECK(std::sqrt(walk.walk.value) == Approx(std::sqrt(2.0)).epsilon(0.02));
}

TEST_CASE("what energy does to a mean is found from fluctuations at constant energy") {
    // K = k + x, U = E - K, and a quantity 3 K + 0.5 U: dK/dE = 1 - 2 var(K)/(f T^2).
    Normal normal(3);
    constexpr double freedom = 300.0;
    constexpr double mean = 150.0;  // T = 1
    std::vector<double> kinetic;
    std::vector<double> potential;
    std::vector<double> mixed;
    for (int k = 0; k < 100000; ++k) {
        kinetic.push_back(mean + 8.0 * normal());
        potential.push_back(-500.0 - kinetic.back());
        mixed.push_back(3.0 * kinetic.back() + 0.5 * potential.back());
    }
    const double of_kinetic = change_with_energy(kinetic, 1.0, kinetic, freedom);
    CHECK(of_kinetic == Approx(1.0 - 2.0 * 64.0 / freedom).epsilon(0.02));
    const double of_potential = change_with_energy(potential, 0.0, kinetic, freedom);
    CHECK(of_kinetic + of_potential == Approx(1.0).epsilon(1e-6));
    CHECK(change_with_energy(mixed, 3.0, kinetic, freedom) ==
          Approx(3.0 * of_kinetic + 0.5 * of_potential).epsilon(1e-6));
}
