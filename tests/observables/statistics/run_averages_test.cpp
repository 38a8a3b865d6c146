#include "ljmd/detail/observables/statistics/run_averages.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include "catch.hpp"

#include "observables/response/response_functions.hpp"
#include "observables/statistics/known_quantities.hpp"

using namespace ljmd;

namespace {

const ObservableAverage& find(const std::vector<ObservableAverage>& averages, const std::string& name) {
    const auto found = std::find_if(averages.begin(), averages.end(),
                                    [&](const ObservableAverage& average) { return average.name == name; });
    REQUIRE(found != averages.end());
    return *found;
}

/// A sample with a number of its own in each place.
Thermodynamics numbered(double x) {
    Thermodynamics sample;
    sample.temperature = 1.0 + x;
    sample.potential_energy = 2.0 + x;
    sample.kinetic_energy = 3.0 + x;
    sample.total_energy = 4.0 + x;
    sample.pressure = 5.0 + x;
    Mat3 tensor;
    tensor << 6.0, 9.0, 10.0, 9.0, 7.0, 11.0, 10.0, 11.0, 8.0;
    sample.pressure_tensor = tensor + Mat3::Constant(x);
    sample.density = 0.5;
    sample.virial = 12.0 + x;
    return sample;
}

/// Temperature and pressure of a made-up run: both wander slowly, and together.
class CorrelatedRun {
  public:
    static constexpr double density = 0.8;

    explicit CorrelatedRun(std::uint64_t seed) : generator_(seed), shared_(noise()), own_(noise()) {}

    Thermodynamics next() {
        const double memory = 0.8;
        const double strength = std::sqrt(1.0 - memory * memory);
        shared_ = memory * shared_ + strength * noise();
        own_ = memory * own_ + strength * noise();
        Thermodynamics sample;
        sample.temperature = 2.0 + 0.4 * shared_;
        sample.pressure = 4.0 + 0.7 * shared_ + 0.1 * own_;
        sample.pressure_tensor = *sample.pressure * Mat3::Identity();
        sample.density = density;
        sample.virial = 1.0;
        return sample;
    }

  private:
    double noise() { return normal_(generator_); }

    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    double shared_;
    double own_;
};

}  // namespace

TEST_CASE("every observable is averaged under its name and has a unit") {
    RunAverages run(10, Ensemble::none);
    for (const double x : {0.0, 1.0, 2.0, 5.0}) {
        run.add(numbered(x));
    }
    CHECK(run.samples() == 4);
    const auto averages = run.averages();
    const std::vector<std::pair<std::string, double>> expected{
        {"temperature", 1.0}, {"potential_energy", 2.0}, {"kinetic_energy", 3.0}, {"total_energy", 4.0},
        {"pressure", 5.0},    {"pressure_xx", 6.0},      {"pressure_yy", 7.0},    {"pressure_zz", 8.0},
        {"pressure_xy", 9.0}, {"pressure_xz", 10.0},     {"pressure_yz", 11.0},   {"virial", 12.0}};
    CHECK(averages.size() == expected.size() + 1);
    for (const auto& [name, first] : expected) {
        const ObservableAverage& average = find(averages, name);
        CAPTURE(name);
        REQUIRE(average.estimate.has_value());
        CHECK(average.estimate->mean == Approx(first + 2.0).epsilon(1e-15));
        CHECK(average.estimate->samples == 4);
        CHECK_FALSE(average.symbol.empty());
        CHECK_FALSE(average.unit.empty());
    }
    CHECK(find(averages, "temperature").unit == "epsilon/k_B");
    CHECK(find(averages, "compressibility_factor").unit == "1");
    CHECK(find(averages, "pressure").unit == "epsilon/sigma^3");
}

TEST_CASE("the compressibility factor is the ratio of the means, not the mean of the ratio") {
    RunAverages run(10, Ensemble::none);
    for (const double x : {0.0, 1.0, 2.0, 5.0}) {
        run.add(numbered(x));
    }
    // <p> = 7, <T> = 3; the mean of p / (rho T) would be 5.83.
    const auto averages = run.averages();
    CHECK(find(averages, "compressibility_factor").estimate->mean == Approx(7.0 / (0.5 * 3.0)).epsilon(1e-15));
}

TEST_CASE(
    "the error of the compressibility factor is the scatter of many runs, correlations in time and with T included") {
    const int runs = 150;
    const int samples = 1024;
    double sum = 0.0;
    double squares = 0.0;
    double reported = 0.0;
    double without_correlation = 0.0;
    for (int k = 0; k < runs; ++k) {
        CorrelatedRun series(static_cast<std::uint64_t>(k));
        RunAverages run(100, Ensemble::none);
        for (int n = 0; n < samples; ++n) {
            run.add(series.next());
        }
        const auto averages = run.averages();
        const Estimate z = *find(averages, "compressibility_factor").estimate;
        const Estimate t = *find(averages, "temperature").estimate;
        const Estimate p = *find(averages, "pressure").estimate;
        sum += z.mean;
        squares += z.mean * z.mean;
        reported += z.standard_error * z.standard_error;
        without_correlation +=
            z.mean * z.mean * (std::pow(t.standard_error / t.mean, 2) + std::pow(p.standard_error / p.mean, 2));
    }
    const double mean = sum / runs;
    const double scatter = std::sqrt(squares / runs - mean * mean);
    CHECK(mean == Approx(4.0 / (2.0 * CorrelatedRun::density)).epsilon(1e-3));
    CHECK(std::sqrt(reported / runs) == Approx(scatter).epsilon(0.25));
    // The test can tell: had the correlation of p and T been left out, the error would be much larger.
    CHECK(std::sqrt(without_correlation / runs) > 3.0 * scatter);
}

TEST_CASE("what a bath exchanges slowly shows in the total energy, and lengthens the blocks of all that it is in") {
    const auto averages = [](double exchange) {
        std::mt19937_64 generator(5);
        std::normal_distribution<double> normal;
        RunAverages run(100, Ensemble::none);
        double slow = 0.0;
        for (int k = 0; k < 4096; ++k) {
            slow = 0.998 * slow + 0.063 * normal(generator);  // 500 samples long
            const double fast = normal(generator);
            Thermodynamics sample = numbered(0.0);
            sample.kinetic_energy = 1.5 + fast + 0.1 * exchange * slow;
            sample.potential_energy = -5.0 - fast + 0.1 * exchange * slow;
            sample.total_energy = sample.kinetic_energy + sample.potential_energy;
            sample.temperature = sample.kinetic_energy / 1.5;
            run.add(sample);
        }
        return run.averages();
    };
    const auto shared = averages(1.0);
    const auto none = averages(1e-4);
    for (const char* name : {"temperature", "kinetic_energy", "potential_energy"}) {
        CAPTURE(name);
        CHECK_FALSE(find(shared, name).estimate->converged);
        CHECK(find(none, name).estimate->converged);
        CHECK(find(shared, name).estimate->standard_error > find(none, name).estimate->standard_error);
    }
}

TEST_CASE("shear stress, whose sign a reflection changes, has no part of an energy that is slow") {
    const auto errors = [](bool external_energy) {
        std::mt19937_64 generator(8);
        std::normal_distribution<double> normal;
        RunAverages run(100, Ensemble::none, external_energy);
        double slow = 0.0;
        double stress = 0.0;
        for (int k = 0; k < 8192; ++k) {
            slow = 0.99 * slow + 0.14 * normal(generator);     // 200 samples long
            stress = 0.5 * stress + 0.87 * normal(generator);  // 3 samples long
            Thermodynamics sample = numbered(0.0);
            sample.potential_energy = slow;
            Mat3 tensor = *sample.pressure_tensor;
            tensor(0, 1) = tensor(1, 0) = stress;
            sample.pressure_tensor = tensor;
            run.add(sample);
        }
        return find(run.averages(), "pressure_xy").estimate;
    };
    const auto of_its_own = errors(false);
    CHECK(of_its_own->standard_error == Approx(std::sqrt(3.0 / 8192.0)).epsilon(0.15));
    CHECK(errors(true)->independent_samples < of_its_own->independent_samples);  // a field may have a direction
}

TEST_CASE("a run that is short beside the time of its bath knows it from that time, whatever its samples look like") {
    const auto temperature = [](double exchange, double shared) {
        std::mt19937_64 generator(5);
        std::normal_distribution<double> normal;
        RunAverages run(100, Ensemble::canonical, false, {.exchange = exchange});
        for (int k = 0; k < 4096; ++k) {
            Thermodynamics sample = numbered(0.0);
            sample.kinetic_energy = 1.5 + normal(generator);
            sample.total_energy = sample.kinetic_energy + std::sqrt(shared - 1.0) * normal(generator);
            sample.potential_energy = sample.total_energy - sample.kinetic_energy;
            sample.temperature = sample.kinetic_energy / 1.5;
            run.add(sample);
        }
        return *find(run.averages(), "temperature").estimate;
    };
    const auto converged = [&](double exchange, double shared) { return temperature(exchange, shared).converged; };
    // 4096/(2 k var(E)/var(K)) >= 24
    CHECK(converged(0.0, 2.0));
    CHECK(converged(39.0, 2.0));
    CHECK_FALSE(converged(47.0, 2.0));
    CHECK(converged(20.0, 4.0));
    CHECK_FALSE(converged(24.0, 4.0));
    // |cov(T, E)| = var(K)/1.5, var(E) = 2 var(K) and n_E = 4096/(2 20 2)
    const Estimate slow = temperature(20.0, 2.0);
    CHECK(slow.standard_error == Approx(1.0 / 1.5 / std::sqrt(2.0 * 51.2)).epsilon(0.05));
    CHECK(slow.independent_samples == Approx(102.4).epsilon(0.2));
    CHECK(temperature(0.01, 2.0).standard_error == temperature(0.0, 2.0).standard_error);
}

TEST_CASE("a run that is short beside the time in which its volume relaxes knows it from the barostat") {
    const auto density = [](double mobility) {
        std::mt19937_64 generator(5);
        std::normal_distribution<double> normal;
        RunAverages run(100, Ensemble::isothermal_isobaric, false, {.volume_mobility = mobility});
        for (int k = 0; k < 4096; ++k) {
            Thermodynamics sample = numbered(0.0);
            sample.temperature = 2.0;
            sample.density = 0.5 + 0.01 * normal(generator);
            run.add(sample);
        }
        return *find(run.averages(), "density").estimate;
    };
    // kappa = N var(rho)/(rho^3 T) = 0.04, and 4096 m/(2 kappa) >= 32
    CHECK(density(0.0).converged);
    CHECK(density(6.6e-4).converged);
    CHECK_FALSE(density(5.9e-4).converged);
    const Estimate slow = density(1e-3);
    CHECK(slow.standard_error == Approx(0.01 / std::sqrt(51.2)).epsilon(0.05));
    CHECK(slow.independent_samples == Approx(51.2).epsilon(0.2));
    CHECK(density(100.0).standard_error == density(0.0).standard_error);
}

TEST_CASE("response functions have no value where the density is a guess") {
    const Estimate known{1.0, 0.1, 30.0, 100, true};
    const Estimate guess{1.0, 0.1, 30.0, 100, false};
    for (const Estimate& of_density : {known, guess}) {
        std::vector<ObservableAverage> averages{average_of("density", of_density),
                                                average_of("isothermal_compressibility", known),
                                                average_of("pressure", known)};
        withhold_slow_responses(averages);
        CHECK(averages[1].estimate.has_value() == of_density.converged);
        CHECK(averages[1].remark.empty() == of_density.converged);
        CHECK(averages[2].estimate);
    }
    std::vector<ObservableAverage> constant_volume{average_of("isothermal_compressibility", known)};
    withhold_slow_responses(constant_volume);
    CHECK(constant_volume[0].estimate);
}

TEST_CASE("where shear stress relaxes too slowly for the run, collisions are rare and what they change is a guess") {
    const auto averages = [](double memory, bool apart) {
        std::mt19937_64 generator(5);
        std::normal_distribution<double> normal;
        RunAverages run(100, Ensemble::canonical);
        Vec3 shear = Vec3::Zero();
        for (int k = 0; k < 4096; ++k) {
            for (double& each : shear) {
                each = memory * each + std::sqrt(1.0 - memory * memory) * normal(generator);
            }
            Thermodynamics sample = numbered(normal(generator));
            sample.pressure_tensor = Mat3{{1.0, shear[0], shear[1]}, {0.0, 1.0, shear[2]}, {0.0, 0.0, 1.0}};
            sample.virial = apart && k % 3 != 0 ? 0.0 : 1.0 + sample.virial;
            run.add(sample);
        }
        return run.averages();
    };
    for (const char* name : {"potential_energy", "total_energy", "pressure", "compressibility_factor", "virial"}) {
        CAPTURE(name);
        CHECK(find(averages(0.98, false), name).estimate->converged);         // 41 independent samples of each stress
        CHECK_FALSE(find(averages(0.997, false), name).estimate->converged);  // 6
        CHECK(find(averages(0.997, true), name).estimate->converged);         // encounters are counted
    }
    CHECK(find(averages(0.997, false), "temperature").estimate->converged);
    CHECK(find(averages(0.98, false), "heat_capacity_cv").estimate.has_value());
    CHECK_FALSE(find(averages(0.997, false), "heat_capacity_cv").estimate.has_value());
}

TEST_CASE("a volume that a barostat changes slowly lengthens the blocks of all averages") {
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal;
    RunAverages run(100, Ensemble::isothermal_isobaric);
    double slow = 0.0;
    for (int k = 0; k < 4096; ++k) {
        slow = 0.998 * slow + 0.063 * normal(generator);
        Thermodynamics sample = numbered(0.0);
        sample.density = 0.5 + 0.01 * slow;
        sample.pressure = 1.0 + normal(generator) - 0.1 * slow;
        run.add(sample);
    }
    CHECK_FALSE(find(run.averages(), "density").estimate->converged);
    CHECK_FALSE(find(run.averages(), "pressure").estimate->converged);
}

TEST_CASE("an energy that is conserved is known to its standard deviation") {
    RunAverages run(100, Ensemble::constant_energy);
    for (const double x : {0.0, 1.0, 2.0, 5.0}) {
        run.add(numbered(x));
    }
    const Estimate energy = *find(run.averages(), "total_energy").estimate;
    CHECK(energy.mean == Approx(6.0));
    CHECK(energy.standard_error == Approx(std::sqrt(14.0 / 3.0)));
    CHECK(std::isnan(energy.independent_samples));
    CHECK(energy.converged);
    RunAverages one(100, Ensemble::constant_energy);
    one.add(numbered(0.0));
    CHECK(std::isnan(find(one.averages(), "total_energy").estimate->standard_error));
}

TEST_CASE("without samples there are no averages") {
    CHECK(RunAverages(10, Ensemble::none).averages().empty());
    CHECK(RunAverages(10, Ensemble::none).samples() == 0);
}

TEST_CASE("a gas whose atoms meet rarely has errors that are guesses, and no compressibility factor if none have met") {
    const auto found = [](Index encounters) {
        RunAverages averages(32, Ensemble::canonical);
        for (Index k = 0; k < 4000; ++k) {
            const bool meet = k % 100 < 3 && k / 100 < encounters;  // three samples each
            Thermodynamics sample = numbered(0.1 * std::sin(static_cast<double>(k)));
            sample.virial = meet ? 1.0 : 0.0;
            averages.add(sample);
        }
        return averages.averages();
    };
    for (const std::string name : {"potential_energy", "virial", "compressibility_factor"}) {
        CAPTURE(name);
        CHECK(find(found(16), name).estimate.value().converged);
        CHECK_FALSE(find(found(15), name).estimate.value().converged);
        CHECK_FALSE(find(found(1), name).estimate.value().converged);
    }
    CHECK(find(found(1), "temperature").estimate.value().converged);
    const ObservableAverage none = find(found(0), "compressibility_factor");
    CHECK_FALSE(none.estimate.has_value());
    CHECK_THAT(none.remark, Catch::Contains("no two atoms were within the cutoff"));
}

TEST_CASE("one atom has neither temperature nor pressure, but the other averages, and it says why") {
    RunAverages run(1, Ensemble::canonical);
    Thermodynamics sample = numbered(0.0);
    sample.temperature.reset();
    sample.pressure.reset();
    sample.pressure_tensor.reset();
    run.add(sample);
    const auto averages = run.averages();
    CHECK(averages.size() == 14);
    for (const ObservableAverage& average : averages) {
        CAPTURE(average.name);
        const bool defined = average.name == "virial" || average.name.ends_with("energy");
        CHECK(average.estimate.has_value() == defined);
        CHECK(average.remark.empty() == defined);
    }
    CHECK(find(averages, "potential_energy").estimate->mean == 2.0);
}

TEST_CASE("of atoms at rest there is a temperature but nothing that is divided by it") {
    // What rounding leaves of the motion of atoms in a crystal is no temperature either.
    for (const double at_rest : {0.0, 1e-30}) {
        for (const Ensemble ensemble : {Ensemble::constant_energy, Ensemble::canonical}) {
            RunAverages run(10, ensemble);
            for (int n = 0; n < 8; ++n) {
                Thermodynamics sample = numbered(0.0);
                sample.temperature = at_rest;
                run.add(sample);
            }
            const auto averages = run.averages();
            CHECK(find(averages, "temperature").estimate->mean == Approx(at_rest));
            CHECK(find(averages, "pressure").estimate->mean == 5.0);
            for (const char* name : {"compressibility_factor", "heat_capacity_cv"}) {
                CHECK_FALSE(find(averages, name).estimate.has_value());
                CHECK_FALSE(find(averages, name).remark.empty());
            }
        }
    }
}

TEST_CASE("the error of a mean is unknown with few samples, and 0 for a constant") {
    RunAverages run(10, Ensemble::none);
    for (int n = 0; n < 3; ++n) {
        run.add(numbered(0.0));
    }
    CHECK(std::isnan(find(run.averages(), "pressure").estimate->standard_error));
    CHECK(std::isnan(find(run.averages(), "compressibility_factor").estimate->standard_error));
    run.add(numbered(0.0));
    CHECK(find(run.averages(), "pressure").estimate->standard_error == 0.0);
    CHECK(find(run.averages(), "compressibility_factor").estimate->standard_error == 0.0);
}

TEST_CASE("the heat capacity at constant energy is that of the fluctuations of the temperature") {
    RunAverages run(3, Ensemble::constant_energy);  // six degrees of freedom
    for (int n = 0; n < 64; ++n) {
        for (const double t : {0.9, 1.0, 1.0, 1.1}) {
            Thermodynamics sample;
            sample.temperature = t;
            run.add(sample);
        }
    }
    const double mean_inverse = (1.0 / 0.9 + 2.0 + 1.0 / 1.1) / 4.0;
    const ObservableAverage found = find(run.averages(), "heat_capacity_cv");
    CHECK(found.unit == "k_B");
    CHECK(found.estimate->mean == Approx(1.0 / (3.0 * (1.0 - 2.0 / 3.0 * mean_inverse)) + 0.5).epsilon(1e-12));

    RunAverages thermostatted(3, Ensemble::none);
    thermostatted.add(numbered(1.0));
    const auto averages = thermostatted.averages();
    CHECK(std::none_of(averages.begin(), averages.end(), [](const auto& a) { return a.name == "heat_capacity_cv"; }));
}

TEST_CASE("fluctuations that no heat capacity allows have none, and it says why") {
    RunAverages wild(100, Ensemble::constant_energy);
    for (const double t : {0.5, 1.0, 1.0, 1.5}) {
        Thermodynamics sample;
        sample.temperature = t;
        wild.add(sample);
    }
    const ObservableAverage found = find(wild.averages(), "heat_capacity_cv");
    CHECK_FALSE(found.estimate.has_value());
    CHECK_THAT(found.remark, Catch::Contains("fluctuates more than any heat capacity allows"));
}

namespace {

/// Normal numbers, each with a correlation of `kept` to the one before.
class Wandering {
  public:
    Wandering(double kept, int seed)
        : kept_(kept), generator_(static_cast<std::uint64_t>(seed)), value_(normal_(generator_)) {}

    double next() { return value_ = kept_ * value_ + std::sqrt(1.0 - kept_ * kept_) * normal_(generator_); }

  private:
    double kept_;
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    double value_;
};

/// Many correlated runs with a heat capacity of 2.5: the mean that they find, and the error that they report, must be
/// those of their scatter.
/// @param sample_of  a normal number as a sample of the ensemble
template <class Sample>
void check_heat_capacity_of_many_runs(Index atoms, Ensemble ensemble, const Sample& sample_of) {
    const int runs = 200;
    double sum = 0.0;
    double squares = 0.0;
    double reported = 0.0;
    for (int k = 0; k < runs; ++k) {
        Wandering memory(0.8, k);
        RunAverages run(atoms, ensemble);
        for (int n = 0; n < 2048; ++n) {
            run.add(sample_of(memory.next()));
        }
        const Estimate c = *find(run.averages(), "heat_capacity_cv").estimate;
        sum += c.mean;
        squares += c.mean * c.mean;
        reported += c.standard_error * c.standard_error;
    }
    const double mean = sum / runs;
    const double scatter = std::sqrt(squares / runs - mean * mean);
    CHECK(std::abs(mean - 2.5) < 0.05);
    CHECK(std::sqrt(reported / runs) / scatter == Approx(1.0).margin(0.2));
}

}  // namespace

TEST_CASE("the error of the heat capacity is the scatter of many runs") {
    // 300 degrees of freedom: <T> <1/T> = 1 + v with (1 - 2/f) (1 + v) = 1 - 1/(N c_v - 3/2), and v = w^2 + 3 w^4 where
    // the relative fluctuations of T are normal, of width w.
    const double v = (1.0 - 1.0 / (101.0 * 2.5 - 1.5)) / (1.0 - 2.0 / 300.0) - 1.0;
    const double width = std::sqrt(v - 3.0 * v * v);
    check_heat_capacity_of_many_runs(101, Ensemble::constant_energy, [&](double normal) {
        Thermodynamics sample;
        sample.temperature = 0.7 * (1.0 + width * normal);
        return sample;
    });
    // Variance of u in the canonical ensemble: (c - 3/2) T^2/N.
    const double energy_width = std::sqrt(1.0 * 0.49 / 100.0);
    check_heat_capacity_of_many_runs(100, Ensemble::canonical, [&](double normal) {
        Thermodynamics sample;
        sample.temperature = 0.7;
        sample.potential_energy = -3.0 + energy_width * normal;
        return sample;
    });
}

TEST_CASE("the error of the heat capacity knows slow fluctuations below fast ones, as a gas has") {
    // White energies of variance 1 and slow ones of 0.1, which make the variance of the whole three times less certain.
    constexpr Index atoms = 100;
    constexpr int runs = 100;
    double sum = 0.0;
    double squares = 0.0;
    double reported = 0.0;
    for (int k = 0; k < runs; ++k) {
        Wandering fast(0.0, k);
        Wandering slow(0.995, runs + k);
        RunAverages run(atoms, Ensemble::canonical);
        for (int n = 0; n < 16384; ++n) {
            Thermodynamics sample;
            sample.temperature = 1.0;
            sample.potential_energy = 0.1 * (fast.next() + std::sqrt(0.1) * slow.next());
            run.add(sample);
        }
        const Estimate c = *find(run.averages(), "heat_capacity_cv").estimate;
        sum += c.mean;
        squares += c.mean * c.mean;
        reported += c.standard_error * c.standard_error;
    }
    const double mean = sum / runs;
    const double scatter = std::sqrt(squares / runs - mean * mean);
    CHECK(mean == Approx(2.6).epsilon(0.02));
    CHECK(std::sqrt(reported / runs) / scatter == Approx(1.0).margin(0.2));
}

TEST_CASE("the errors of virial and compressibility factor know slow pairs below the noise of collisions") {
    // As in a gas: bound pairs make the energy, and are hidden in the virial below collisions.
    constexpr int runs = 400;
    constexpr double volume = 1000.0;
    constexpr double density = 0.1;
    constexpr double per_virial = 1.0 / (3.0 * volume);
    for (const std::string name : {"virial", "compressibility_factor"}) {
        double sum = 0.0;
        double squares = 0.0;
        double reported = 0.0;
        int known = 0;
        for (int k = 0; k < runs; ++k) {
            Wandering motion(0.0, 3 * k);
            Wandering collisions(0.0, 3 * k + 1);
            Wandering pairs(0.967, 3 * k + 2);
            RunAverages run(100, Ensemble::canonical);
            for (int n = 0; n < 2048; ++n) {
                const double slow = pairs.next();
                Thermodynamics sample;
                sample.temperature = 1.0 + 0.08 * motion.next();
                sample.potential_energy = -0.1 + 0.01 * slow;
                sample.virial = 10.0 + 30.0 * (collisions.next() + 0.18 * slow);
                sample.density = density;
                sample.pressure = density * *sample.temperature + per_virial * sample.virial;
                run.add(sample);
            }
            const Estimate found = *find(run.averages(), name).estimate;
            if (found.converged) {
                ++known;
                sum += found.mean;
                squares += found.mean * found.mean;
                reported += found.standard_error * found.standard_error;
            }
        }
        const double mean = sum / known;
        const double ratio = std::sqrt((squares / known - mean * mean) / (reported / known));
        CAPTURE(name, known, ratio);
        CHECK(known > runs / 2);
        CHECK(ratio > 0.8);
        CHECK(ratio < 1.06);  // 1.2 with blocks that the virial alone needs
    }
}

TEST_CASE("the error of the heat capacity of a short run covers what it has not seen, or there is none") {
    // The variance of u is that of c_v = 2.5; runs hold 1, 31 and 107 independent samples.
    const double energy_width = std::sqrt(1.0 * 0.49 / 100.0);
    struct Case {
        double kept;
        int min_with_value;
        int max_with_value;
    };
    const auto c = GENERATE(Case{0.999, 0, 20}, Case{0.97, 0, 20}, Case{0.9, 150, 200});
    const int runs = 200;
    int with_value = 0;
    double squares = 0.0;
    double reported = 0.0;
    int far_off = 0;
    for (int k = 0; k < runs; ++k) {
        Wandering memory(c.kept, k);
        RunAverages run(100, Ensemble::canonical);
        for (int n = 0; n < 2048; ++n) {
            Thermodynamics sample;
            sample.temperature = 0.7;
            sample.potential_energy = -3.0 + energy_width * memory.next();
            run.add(sample);
        }
        const ObservableAverage found = find(run.averages(), "heat_capacity_cv");
        CHECK(found.estimate.has_value() == found.remark.empty());
        if (found.estimate) {
            ++with_value;
            squares += std::pow(found.estimate->mean - 2.5, 2);
            reported += std::pow(found.estimate->standard_error, 2);
            far_off += std::abs(found.estimate->mean - 2.5) > 3.0 * found.estimate->standard_error ? 1 : 0;
        }
    }
    CAPTURE(c.kept, with_value, squares, reported, far_off);
    CHECK(with_value >= c.min_with_value);
    CHECK(with_value <= c.max_with_value);
    if (c.min_with_value > 0) {
        CHECK(std::sqrt(squares / reported) < 1.32);
        CHECK(std::sqrt(squares / reported) > 0.7);
        CHECK(far_off <= 9);  // by chance 4.8 of 200, and two standard deviations of that
    }
}

namespace {

/// The heat capacity from samples of an ensemble.
template <class Sample>
double heat_capacity_of(Index atoms, Ensemble ensemble, const Sample& sample_of) {
    std::mt19937_64 generator(5);
    RunAverages run(atoms, ensemble);
    for (int n = 0; n < 100000; ++n) {
        run.add(sample_of(generator));
    }
    return find(run.averages(), "heat_capacity_cv").estimate->mean;
}

}  // namespace

TEST_CASE("the heat capacity of few harmonic oscillators has no error of the order 1/N, at constant energy") {
    // Nine degrees of freedom of the motion about the centre of mass, nine harmonic ones, energy 1: the kinetic energy
    // has a beta distribution. C = 9 without, 10.5 with the motion of the centre of mass.
    std::gamma_distribution<double> gamma(4.5);
    const double c = heat_capacity_of(4, Ensemble::constant_energy, [&](auto& generator) {
        const double k = gamma(generator);
        Thermodynamics sample;
        sample.temperature = 2.0 / 9.0 * k / (k + gamma(generator));
        return sample;
    });
    CHECK(c == Approx(10.5 / 4.0).epsilon(0.01));
}

TEST_CASE("the heat capacity in the canonical ensemble is the same whether or not the centre of mass moves") {
    for (const double freedom : {9.0, 12.0}) {  // of the motion of four atoms; nine harmonic ones
        CAPTURE(freedom);
        std::gamma_distribution<double> kinetic(0.5 * freedom);
        std::gamma_distribution<double> potential(4.5);
        const double c = heat_capacity_of(4, Ensemble::canonical, [&](auto& generator) {
            Thermodynamics sample;
            sample.temperature = 1.0;
            sample.kinetic_energy = kinetic(generator) / 4.0;
            sample.potential_energy = potential(generator) / 4.0;
            sample.total_energy = sample.kinetic_energy + sample.potential_energy;
            return sample;
        });
        CHECK(c == Approx(10.5 / 4.0).epsilon(0.02));
    }
}

TEST_CASE("the heat capacity in the canonical ensemble is that of the fluctuations of the potential energy") {
    RunAverages run(50, Ensemble::canonical);
    for (int n = 0; n < 64; ++n) {
        for (const double e : {-2.9, -3.0, -3.0, -3.1}) {
            Thermodynamics sample;
            sample.temperature = 0.5;
            sample.potential_energy = e;
            run.add(sample);
        }
    }
    CHECK(find(run.averages(), "heat_capacity_cv").estimate->mean == Approx(50.0 * 0.005 / 0.25 + 1.5).epsilon(1e-12));
}

TEST_CASE("a density that fluctuates is an observable, and the compressibility factor is that of its mean") {
    RunAverages run(10, Ensemble::constant_pressure);
    for (const double x : {-0.1, 0.0, 0.1, 0.2}) {
        Thermodynamics sample = numbered(0.0);
        sample.temperature = 2.0;
        sample.density = 0.5 + x;
        run.add(sample);
    }
    const auto averages = run.averages();
    CHECK(find(averages, "density").estimate->mean == Approx(0.55).epsilon(1e-14));
    CHECK(find(averages, "density").unit == "sigma^-3");
    const Estimate z = *find(averages, "compressibility_factor").estimate;
    CHECK(z.mean == Approx(5.0 / (0.55 * 2.0)).epsilon(1e-14));
    const Estimate rho = *find(averages, "density").estimate;
    CHECK(z.standard_error / z.mean == Approx(rho.standard_error / rho.mean).epsilon(1e-12));
}
