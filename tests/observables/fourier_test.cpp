#include "observables/fourier.hpp"

#include <cmath>
#include <future>
#include <numbers>
#include <random>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

AlignedVector<double> random_numbers(Index count, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    AlignedVector<double> numbers(static_cast<std::size_t>(count));
    for (double& number : numbers) {
        number = uniform(generator);
    }
    return numbers;
}

double at(const AlignedVector<double>& values, Index k) {
    return values[static_cast<std::size_t>(k)];
}

Complex at(const AlignedVector<Complex>& values, Index k) {
    return values[static_cast<std::size_t>(k)];
}

}  // namespace

TEST_CASE("transforms of several real series are the sums that define them") {
    const Index n = GENERATE(2, 6, 14, 16);
    constexpr Index batch = 5;
    AlignedVector<double> x = random_numbers(n * batch, 3);
    const AlignedVector<double> kept = x;
    AlignedVector<Complex> found(static_cast<std::size_t>((n / 2 + 1) * batch));
    const RealTransform transform(n, batch);
    CHECK(transform.length() == n);
    transform(x, found);
    CHECK(x == kept);
    for (Index series = 0; series < batch; ++series) {
        for (Index k = 0; k <= n / 2; ++k) {
            Complex expected = 0.0;
            for (Index j = 0; j < n; ++j) {
                expected += at(x, series * n + j) *
                            std::polar(1.0, -2.0 * pi * static_cast<double>(j * k % n) / static_cast<double>(n));
            }
            CHECK(std::abs(at(found, series * (n / 2 + 1) + k) - expected) < 1e-14);
        }
    }
}

TEST_CASE("the inverse gives back the series, times its length") {
    constexpr Index n = 30;
    AlignedVector<double> x = random_numbers(n, 4);
    AlignedVector<Complex> transformed(n / 2 + 1);
    RealTransform{n}(x, transformed);
    AlignedVector<double> back(n);
    InverseRealTransform{n}(transformed, back);
    for (Index j = 0; j < n; ++j) {
        CHECK(at(back, j) == Approx(static_cast<double>(n) * at(x, j)).margin(1e-13));
    }
}

TEST_CASE("the transform of a grid is the sum that defines it") {
    const std::array<Index, 3> n{4, 6, 10};
    AlignedVector<double> x = random_numbers(n[0] * n[1] * n[2], 5);
    AlignedVector<Complex> found(static_cast<std::size_t>(n[0] * n[1] * (n[2] / 2 + 1)));
    GridTransform{n}(x, found);
    const auto phase = [](Index j, Index k, Index length) {
        return static_cast<double>(j * k) / static_cast<double>(length);
    };
    for (const std::array<Index, 3>& k : {std::array<Index, 3>{0, 0, 0}, {1, 0, 0}, {3, 5, 2}, {2, 1, 5}, {0, 4, 3}}) {
        Complex expected = 0.0;
        for (Index a = 0; a < n[0]; ++a) {
            for (Index b = 0; b < n[1]; ++b) {
                for (Index c = 0; c < n[2]; ++c) {
                    const double turns = phase(a, k[0], n[0]) + phase(b, k[1], n[1]) + phase(c, k[2], n[2]);
                    expected += at(x, (a * n[1] + b) * n[2] + c) * std::polar(1.0, -2.0 * pi * turns);
                }
            }
        }
        CHECK(std::abs(at(found, (k[0] * n[1] + k[1]) * (n[2] / 2 + 1) + k[2]) - expected) < 1e-12);
    }
}

TEST_CASE("sine and cosine transforms are the sums that define them") {
    const Index n = GENERATE(2, 3, 7, 20);
    AlignedVector<double> x = random_numbers(n, 6);
    AlignedVector<double> sines(x.size());
    AlignedVector<double> cosines(x.size());
    SineTransform{n}(x, sines);
    CosineTransform{n}(x, cosines);
    const auto length = static_cast<double>(n);
    for (Index k = 0; k < n; ++k) {
        const auto frequency = static_cast<double>(k);
        double sine = 0.0;
        double cosine = at(x, 0) + (k % 2 == 0 ? 1.0 : -1.0) * at(x, n - 1);
        for (Index j = 0; j < n; ++j) {
            const auto place = static_cast<double>(j);
            sine += 2.0 * at(x, j) * std::sin(pi * (place + 0.5) * (frequency + 1.0) / length);
            if (j > 0 && j < n - 1) {
                cosine += 2.0 * at(x, j) * std::cos(pi * place * frequency / (length - 1.0));
            }
        }
        CHECK(at(sines, k) == Approx(sine).margin(1e-13));
        CHECK(at(cosines, k) == Approx(cosine).margin(1e-13));
    }
}

TEST_CASE("transforms of no length are refused") {
    CHECK_THROWS_AS(RealTransform(0), ContractViolation);
    CHECK_THROWS_AS(RealTransform(7), ContractViolation);
    CHECK_THROWS_AS(RealTransform(8, 0), ContractViolation);
    CHECK_THROWS_AS(InverseRealTransform(5), ContractViolation);
    CHECK_THROWS_AS(GridTransform({4, 5, 6}), ContractViolation);
    CHECK_THROWS_AS(SineTransform(0), ContractViolation);
    CHECK_THROWS_AS(CosineTransform(1), ContractViolation);
}

TEST_CASE("transforms are made in two threads at a time") {
    const auto make = [] {
        std::size_t made = 0;
        for (Index n = 2; n < 400; n += 2) {
            const SineTransform sine(n);
            const CosineTransform cosine(n);
            const InverseRealTransform inverse(n);
            made += 3;
        }
        return made;
    };
    auto other = std::async(std::launch::async, make);
    CHECK(make() == 597);
    CHECK(other.get() == 597);
}
