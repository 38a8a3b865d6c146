#include "core/random.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>
#include "catch.hpp"

#include "core/kolmogorov_smirnov.hpp"

using namespace ljmd;
using test::kolmogorov_smirnov;

namespace {

constexpr Index many = 100000;

template <class Draw>
std::vector<double> component(int a, const Draw& draw) {
    std::vector<double> numbers;
    for (Index id = 0; id < many; ++id) {
        numbers.push_back(draw(id)[a]);
    }
    return numbers;
}

double correlation(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0.0, sy = 0.0, sxx = 0.0, syy = 0.0, sxy = 0.0;
    const auto n = static_cast<double>(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        sx += x[k];
        sy += y[k];
        sxx += x[k] * x[k];
        syy += y[k] * y[k];
        sxy += x[k] * y[k];
    }
    return (sxy - sx * sy / n) / std::sqrt((sxx - sx * sx / n) * (syy - sy * sy / n));
}

}  // namespace

TEST_CASE("random numbers are those of Philox-4x64-10 and never change") {
    // Computed with numpy.random.Philox(key=[seed, stream], counter=[step, atom, 0, 0]); the first block of all zeros
    // is also in the known answers of its authors (Random123, philox4x64 10).
    struct Case {
        std::uint64_t seed;
        RandomStream stream;
        Index step, atom;
        Vec3 uniform;
    };
    constexpr double unit = 0x1p-53;
    const Case cases[] = {
        {0, RandomStream{0}, 0, 0, {0x2caa9b3d946c6p0, 0x1b641fd3ace5a1p0, 0x1afcee59dc30c2p0}},
        {0, RandomStream::positions, 0, 0, {0x138d64e120be16p0, 0x1bdce9bcb845f7p0, 0x1f7cb0f5f5c12p0}},
        {1967, RandomStream::positions, 0, 863, {0x74cabbce506a7p0, 0x145fd56ce3164ep0, 0x7e9d4d1a67c29p0}},
        {1967, RandomStream::velocities, 0, 0, {0x1d041edcf7b11fp0, 0x5979cfe3d0c52p0, 0xe9de36d132efap0}},
        {1967,
         RandomStream::velocities,
         12345678901,
         4000000000,
         {0x7b0a5e9f8cac2p0, 0x5af8ba8dd8779p0, 0x19b1f763e57961p0}},
        {std::numeric_limits<std::uint64_t>::max(),
         RandomStream::velocities,
         1,
         2,
         {0x8bf3d6d0bfb60p0, 0x1e8300f7aa8a44p0, 0x1ea8fd05d25512p0}},
    };
    for (const Case& c : cases) {
        INFO("seed " << c.seed << ", step " << c.step << ", atom " << c.atom);
        CHECK(Random(c.seed, c.stream).uniform(c.step, c.atom) == unit * c.uniform);
    }
}

TEST_CASE("normal numbers are those of Box and Muller from the same bits and never change") {
    // From the blocks above in 40 digits; the last bits are the mathematical library's.
    const auto check = [](const Vec3& found, const Vec3& expected) {
        CAPTURE(found.transpose(), expected.transpose());
        CHECK((found - expected).cwiseAbs().maxCoeff() < 2e-15);
    };
    check(Random(0, RandomStream::positions).normal(0, 0),
          {0.945201940378999089, -0.997495195554334817, 0.180747502288375651});
    check(Random(1967, RandomStream::velocities).normal(0, 0),
          {0.991885553979707447, 1.93937355579784655, -0.604336058346495963});
    check(Random(1967, RandomStream::velocities).normal(12345678901, 4000000000),
          {0.325429661134394673, 0.666178931021539233, -1.47597466509187914});
    check(Random(std::numeric_limits<std::uint64_t>::max(), RandomStream::velocities).normal(1, 2),
          {0.765250587038811713, -0.230212297906301835, 2.45340035708917774});
}

TEST_CASE("uniform numbers lie between 0 and 1 without 1, carry 53 bits and fill the unit interval evenly") {
    const Random random(42, RandomStream::positions);
    bool inside = true;
    bool low_bits = false;
    for (int a = 0; a < 3; ++a) {
        const auto x = component(a, [&](Index id) { return random.uniform(0, id); });
        for (const double number : x) {
            inside = inside && number >= 0.0 && number < 1.0 && std::fmod(number * 0x1p53, 1.0) == 0.0;
            low_bits = low_bits || std::fmod(number * 0x1p53, 2.0) == 1.0;
        }
        CHECK(kolmogorov_smirnov(x, [](double f) { return f; }) < 1.63);
        constexpr std::size_t bins = 64;
        std::vector<double> counts(bins);
        for (const double number : x) {
            counts[static_cast<std::size_t>(number * bins)] += 1.0;
        }
        const double expected = static_cast<double>(many) / bins;
        double chi_square = 0.0;
        for (const double count : counts) {
            chi_square += (count - expected) * (count - expected) / expected;
        }
        CHECK(chi_square > 36.0);  // 63 degrees of freedom: 99 % lie between 37 and 96
        CHECK(chi_square < 96.0);
    }
    CHECK(inside);
    CHECK(low_bits);
}

TEST_CASE("normal numbers have the moments and the distribution of the normal law") {
    const Random random(42, RandomStream::velocities);
    for (int a = 0; a < 3; ++a) {
        const auto x = component(a, [&](Index id) { return random.normal(3, id); });
        double moments[5] = {};
        for (const double number : x) {
            for (int power = 1; power <= 4; ++power) {
                moments[power] += std::pow(number, power) / static_cast<double>(many);
            }
        }
        const double sigma = 1.0 / std::sqrt(static_cast<double>(many));
        CHECK(std::abs(moments[1]) < 3.5 * sigma);
        CHECK(std::abs(moments[2] - 1.0) < 3.5 * std::sqrt(2.0) * sigma);
        CHECK(std::abs(moments[3]) < 3.5 * std::sqrt(15.0) * sigma);
        CHECK(std::abs(moments[4] - 3.0) < 3.5 * std::sqrt(96.0) * sigma);
        CHECK(kolmogorov_smirnov(x, [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }) < 1.63);
    }
}

TEST_CASE("numbers of different components, atoms, steps, seeds and streams are independent") {
    const Random random(7, RandomStream::velocities);
    const Random other_seed(8, RandomStream::velocities);
    const Random other_stream(7, RandomStream::positions);
    for (const bool normal : {false, true}) {
        const auto draw = [normal](const Random& source, Index step, Index id) {
            return normal ? source.normal(step, id) : source.uniform(step, id);
        };
        const auto first = component(0, [&](Index id) { return draw(random, 0, id); });
        const std::vector<double> others[] = {
            component(1, [&](Index id) { return draw(random, 0, id); }),
            component(2, [&](Index id) { return draw(random, 0, id); }),
            component(0, [&](Index id) { return draw(random, 0, id + 1); }),
            component(0, [&](Index id) { return draw(random, 1, id); }),
            component(0, [&](Index id) { return draw(random, id, 0); }),
            component(0, [&](Index id) { return draw(other_seed, 0, id); }),
            component(0, [&](Index id) { return draw(other_stream, 0, id); }),
        };
        for (const auto& other : others) {
            CHECK(std::abs(correlation(first, other)) < 3.5 / std::sqrt(static_cast<double>(many)));
        }
    }
}

TEST_CASE("no two draws share a number, and a draw depends on nothing but its key") {
    std::set<double> seen;
    std::size_t draws = 0;
    for (const auto stream : {RandomStream::positions, RandomStream::velocities}) {
        for (Index step = 0; step < 30; ++step) {
            for (Index atom = 0; atom < 30; ++atom) {
                for (const double number : Random(5, stream).uniform(step, atom)) {
                    seen.insert(number);
                    ++draws;
                }
            }
        }
    }
    CHECK(seen.size() == draws);

    const Random random(5, RandomStream::velocities);
    const Vec3 before = random.normal(4, 9);
    CHECK(random.uniform(9, 4) != random.uniform(4, 9));
    CHECK(random.normal(std::numeric_limits<Index>::max(), std::numeric_limits<Index>::max()).allFinite());
    CHECK(random.normal(4, 9) == before);
    CHECK(Random(5, RandomStream::velocities).normal(4, 9) == before);
}

TEST_CASE("gamma numbers have the gamma distribution of their shape") {
    const Random random(7, RandomStream::thermostat);
    for (const double shape : {0.5, 1.0, 2.5, 158.5, 5e4}) {
        CAPTURE(shape);
        std::vector<double> x;
        double sum = 0.0;
        for (Index step = 0; step < many; ++step) {
            x.push_back(random.gamma(step, 1, shape));
            sum += x.back();
        }
        CHECK(kolmogorov_smirnov(x, [&](double g) { return gsl_cdf_gamma_P(g, shape, 1.0); }) < 1.63);
        CHECK(std::abs(sum / static_cast<double>(many) - shape) < 4.0 * std::sqrt(shape / static_cast<double>(many)));
    }
}

TEST_CASE("a gamma number is a function of seed, stream, step and atom alone") {
    const Random random(7, RandomStream::thermostat);
    std::set<double> seen;
    for (const std::uint64_t seed : {7U, 8U}) {
        for (const RandomStream stream : {RandomStream::thermostat, RandomStream::barostat}) {
            for (const Index step : {0, 1}) {
                for (const Index atom : {0, 1}) {
                    seen.insert(Random(seed, stream).gamma(step, atom, 3.0));
                    CHECK(Random(seed, stream).gamma(step, atom, 3.0) == Random(seed, stream).gamma(step, atom, 3.0));
                }
            }
        }
    }
    CHECK(seen.size() == 16);
    // It must not change: checkpoints rest on it.
    CHECK(random.gamma(5, 1, 158.5) == 144.3456726819955);
}
