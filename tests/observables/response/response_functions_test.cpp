#include "observables/response/response_functions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"

using namespace ljmd;

namespace {

using Found = std::map<std::string, ObservableAverage>;

Found by_name(const ResponseFunctions& responses) {
    Found found;
    for (const ObservableAverage& each : responses.observables()) {
        found.emplace(each.name, each);
    }
    return found;
}

// A model with known answers in every ensemble: N free atoms, and g oscillators whose spring constants go with
// V^(-2 G) (Grueneisen). U is the energy of the springs, P = 2 G U/V and V times its derivative -(1 + 2 G) P, so that
// the stiffness is 2 G P. From the canonical mean U = g T/2:
//
//     p = rho T + G g T/V,  gamma_V = p/T,  K_T = p,  c_v = 3/2 + g/(2 N)
constexpr Index atoms = 20;
constexpr double n = 20.0;
constexpr double oscillators = 40.0;
constexpr double grueneisen = 1.7;
constexpr double temperature_held = 1.3;
constexpr double box_volume = 25.0;
constexpr double freedom = 3.0 * n - 3.0;

double gamma_number(std::mt19937_64& generator, double shape) {
    return std::gamma_distribution<double>(shape)(generator);
}

ResponseSample sample_of(double energy, double temperature) {
    const double pressure = 2.0 * grueneisen * energy / box_volume;
    return {temperature, energy / n, pressure, box_volume / n, 2.0 * grueneisen * pressure};
}

ResponseSample canonical_sample(std::mt19937_64& generator) {
    const double energy = temperature_held * gamma_number(generator, 0.5 * oscillators);
    return sample_of(energy, temperature_held * gamma_number(generator, 0.5 * freedom) / (0.5 * freedom));
}

ResponseSample energetic_sample(std::mt19937_64& generator) {
    const double total = 0.5 * temperature_held * (oscillators + freedom);
    const double springs = gamma_number(generator, 0.5 * oscillators);
    const double motion = gamma_number(generator, 0.5 * freedom);
    const double energy = total * springs / (springs + motion);
    return sample_of(energy, 2.0 * (total - energy) / freedom);
}

/// An ideal gas at a pressure, with oscillators in its atoms: the volume has the density V^N exp(-p V/T).
ResponseSample gas_sample(std::mt19937_64& generator) {
    const double volume = temperature_held / 0.9 * gamma_number(generator, n + 1.0);
    const double energy = temperature_held * gamma_number(generator, 0.5 * oscillators);
    return {temperature_held * gamma_number(generator, 0.5 * freedom) / (0.5 * freedom), energy / n, 0.0, volume / n,
            0.0};
}

template <class Sample>
Found measured(Ensemble ensemble, const Sample& sample, int samples, std::uint64_t seed) {
    ResponseFunctions responses(atoms, ensemble, 0.9, true);
    std::mt19937_64 generator(seed);
    for (int k = 0; k < samples; ++k) {
        responses.add(sample(generator));
    }
    return by_name(responses);
}

struct Expected {
    double kappa_t, alpha, gamma_v, c_p, kappa_s, sound, joule_thomson;
};

Expected expected_of(double t, double rho, double gamma_v, double modulus, double c_v) {
    const double alpha = gamma_v / modulus;
    const double c_p = c_v + t * alpha * gamma_v / rho;
    const double adiabatic = modulus * c_p / c_v;
    return {1.0 / modulus,
            alpha,
            gamma_v,
            c_p,
            1.0 / adiabatic,
            std::sqrt(adiabatic / rho),
            (t * alpha - 1.0) / (rho * c_p)};
}

void check_all(const Found& found, const Expected& expected) {
    const auto check = [&](const char* name, double value) {
        const ObservableAverage& average = found.at(name);
        CAPTURE(name, average.remark);
        REQUIRE(average.estimate.has_value());
        CAPTURE(average.estimate->mean, average.estimate->standard_error, value);
        CHECK(std::abs(average.estimate->mean - value) < 5.0 * average.estimate->standard_error);
        CHECK(average.estimate->standard_error < 0.1 * std::abs(value) + 0.02);
    };
    check("isothermal_compressibility", expected.kappa_t);
    check("thermal_expansion", expected.alpha);
    check("thermal_pressure_coefficient", expected.gamma_v);
    check("heat_capacity_cp", expected.c_p);
    check("adiabatic_compressibility", expected.kappa_s);
    check("speed_of_sound", expected.sound);
    check("joule_thomson_coefficient", expected.joule_thomson);
}

Expected of_oscillators() {
    const double rho = n / box_volume;
    const double gamma_v = rho + grueneisen * oscillators / box_volume;
    return expected_of(temperature_held, rho, gamma_v, gamma_v * temperature_held, 1.5 + 0.5 * oscillators / n);
}

}  // namespace

TEST_CASE("fluctuations in the canonical ensemble give the derivatives of the equation of state") {
    const Found found = measured(Ensemble::canonical, canonical_sample, 400000, 1);
    check_all(found, of_oscillators());
    CHECK_FALSE(found.contains("heat_capacity_cv"));  // that of RunAverages
}

TEST_CASE("so do those at constant energy, for any number of atoms") {
    check_all(measured(Ensemble::constant_energy, energetic_sample, 400000, 2), of_oscillators());
}

TEST_CASE("so do those at constant pressure: an ideal gas") {
    const Found found = measured(Ensemble::isothermal_isobaric, gas_sample, 200000, 3);
    // To order 1/N: <V> = (N + 1) T/p.
    const double rho = 0.9 * n / (temperature_held * (n + 1.0));
    const double c_p = 2.5 + (1.0 + 0.5 * oscillators) / n;
    const double alpha = 1.0 / temperature_held;
    const double kappa = 1.0 / 0.9;
    const double c_v = c_p - temperature_held * alpha * alpha / (rho * kappa);
    check_all(found, expected_of(temperature_held, rho, alpha / kappa, 1.0 / kappa, c_v));
    CHECK(std::abs(found.at("heat_capacity_cv").estimate->mean - c_v) <
          5.0 * found.at("heat_capacity_cv").estimate->standard_error);
}

TEST_CASE("the scatter over 60 series is what their errors say, in every ensemble") {
    const auto check_scatter = [](Ensemble ensemble, const auto& sample) {
        std::map<std::string, std::vector<Estimate>> all;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            for (const auto& [name, average] : measured(ensemble, sample, 4000, 100 + seed)) {
                REQUIRE(average.estimate.has_value());
                all[name].push_back(*average.estimate);
            }
        }
        for (const auto& [name, estimates] : all) {
            const auto count = static_cast<double>(estimates.size());
            double centre = 0.0;
            double squares = 0.0;
            double reported = 0.0;
            for (const Estimate& each : estimates) {
                centre += each.mean / count;
                reported += each.standard_error * each.standard_error / count;
            }
            for (const Estimate& each : estimates) {
                squares += (each.mean - centre) * (each.mean - centre) / (count - 1.0);
            }
            const double ratio = std::sqrt(squares / reported);
            CAPTURE(name, ratio);
            CHECK(ratio > 0.7);
            CHECK(ratio < 1.32);
        }
    };
    check_scatter(Ensemble::canonical, canonical_sample);
    check_scatter(Ensemble::constant_energy, energetic_sample);
    check_scatter(Ensemble::isothermal_isobaric, gas_sample);
}

TEST_CASE("a slow volume does not hide how well the fluctuation of the energy beside it is known") {
    constexpr int seeds = 40;
    constexpr int samples = 24000;
    constexpr int same_volume = 400;
    double sum = 0.0;
    double squares = 0.0;
    double reported = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        ResponseFunctions responses(atoms, Ensemble::isothermal_isobaric, 0.9, true);
        std::mt19937_64 generator(seed);
        double volume = 0.0;
        for (int k = 0; k < samples; ++k) {
            ResponseSample sample = gas_sample(generator);
            volume = k % same_volume == 0 ? sample.volume : volume;
            sample.volume = volume;
            responses.add(sample);
        }
        const Found found = by_name(responses);
        const ObservableAverage& c = found.at("heat_capacity_cv");
        REQUIRE(c.estimate.has_value());
        sum += c.estimate->mean;
        squares += c.estimate->mean * c.estimate->mean;
        reported += c.estimate->standard_error * c.estimate->standard_error / seeds;
    }
    const double ratio = std::sqrt((squares - sum * sum / seeds) / (seeds - 1) / reported);
    CAPTURE(ratio);
    CHECK(ratio > 0.75);
    CHECK(ratio < 1.3);
}

TEST_CASE("errors are those of a jackknife over blocks of the series") {
    constexpr int blocks = 200;
    constexpr int length = 200;
    const auto without = [&](int left_out) {
        ResponseFunctions responses(atoms, Ensemble::canonical, std::nullopt, true);
        std::mt19937_64 generator(7);
        for (int k = 0; k < blocks * length; ++k) {
            const ResponseSample sample = canonical_sample(generator);
            if (k / length != left_out) {
                responses.add(sample);
            }
        }
        return by_name(responses);
    };
    const Found whole = without(-1);
    std::map<std::string, double> sums;
    std::map<std::string, double> squares;
    for (int block = 0; block < blocks; ++block) {
        for (const auto& [name, average] : without(block)) {
            const double difference = average.estimate->mean - whole.at(name).estimate->mean;
            sums[name] += difference;
            squares[name] += difference * difference;
        }
    }
    for (const auto& [name, average] : whole) {
        const double jackknife =
            std::sqrt((blocks - 1.0) * (squares[name] / blocks - std::pow(sums[name] / blocks, 2)));
        CAPTURE(name, jackknife, average.estimate->standard_error);
        CHECK(average.estimate->standard_error == Approx(jackknife).epsilon(0.25));  // each is known to 5 to 18 %
    }
}

TEST_CASE("what cannot be known has a remark instead of a value") {
    const auto check_none = [](const Found& found, const std::string& name, const std::string& part) {
        CAPTURE(name, part);
        CHECK_FALSE(found.at(name).estimate.has_value());
        CHECK_THAT(found.at(name).remark, Catch::Matchers::Contains(part));
    };
    const Found few = measured(Ensemble::canonical, canonical_sample, 10, 1);
    check_none(few, "thermal_pressure_coefficient", "too short");
    check_none(few, "isothermal_compressibility", "too short");
    check_none(measured(Ensemble::none, canonical_sample, 4000, 1), "speed_of_sound", "one sampled stage");
    check_none(measured(Ensemble::constant_pressure, gas_sample, 4000, 1), "thermal_expansion", "one sampled stage");
    const auto at_rest = [](std::mt19937_64& generator) {
        ResponseSample sample = canonical_sample(generator);
        sample.temperature = 0.0;
        return sample;
    };
    check_none(measured(Ensemble::canonical, at_rest, 4000, 1), "heat_capacity_cp", no_temperature);

    ResponseFunctions rows(atoms, Ensemble::canonical, std::nullopt, false);
    CHECK(rows.observables().empty());
    std::mt19937_64 generator(1);
    for (int k = 0; k < 4000; ++k) {
        rows.add(canonical_sample(generator));
    }
    const Found found = by_name(rows);
    check_none(found, "isothermal_compressibility", "hypervirial");
    CHECK(found.at("thermal_pressure_coefficient").estimate.has_value());
}

TEST_CASE("a fluid whose stiffness is hidden by noise has no compressibility, but a pressure coefficient") {
    const auto noisy = [](std::mt19937_64& generator) {
        ResponseSample sample = canonical_sample(generator);
        sample.stiffness += std::normal_distribution<double>(0.0, 200.0)(generator);
        return sample;
    };
    const Found found = measured(Ensemble::canonical, noisy, 4000, 4);
    CHECK_FALSE(found.at("isothermal_compressibility").estimate.has_value());
    CHECK_FALSE(found.at("speed_of_sound").estimate.has_value());
    CHECK(found.at("thermal_pressure_coefficient").estimate.has_value());
}

TEST_CASE("response functions go on from an archive to the same bits") {
    ResponseFunctions whole(atoms, Ensemble::constant_energy, std::nullopt, true);
    ResponseFunctions first = whole;
    std::mt19937_64 generator(5);
    for (int k = 0; k < 3000; ++k) {
        if (k == 1234) {
            ResponseFunctions restored(atoms, Ensemble::constant_energy, std::nullopt, true);
            test::through_archive(first, restored);
            first = restored;
        }
        const ResponseSample sample = energetic_sample(generator);
        whole.add(sample);
        first.add(sample);
    }
    const Found a = by_name(whole);
    for (const auto& [name, average] : by_name(first)) {
        CHECK(average.estimate->mean == a.at(name).estimate->mean);
        CHECK(average.estimate->standard_error == a.at(name).estimate->standard_error);
    }
}
