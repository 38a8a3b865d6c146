#include "execution/simd_vector.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>
#include "catch.hpp"

using namespace ljmd;

namespace {

/// Vectors of any width, compiled for the processor of the tests: the compilers split those that are too wide.
struct Test;
template <class T, int lanes>
using Vec = simd::Vec<T, lanes, Test>;

template <class V>
V ramp(double first, double step) {
    V v;
    for (int k = 0; k < V::lanes; ++k) {
        v.raw[k] = static_cast<typename V::Value>(first + step * k);
    }
    return v;
}

/// f in each lane, by the vector and by the number.
template <class V, class F, class G>
void same_in_every_lane(const V& x, F by_vector, G by_number) {
    const V result = by_vector(x);
    for (int k = 0; k < V::lanes; ++k) {
        CHECK(result.raw[k] == by_number(x.raw[k]));
    }
}

/// Largest error of exp, in units in the last place of the result.
template <class V>
double worst_exp(double from, double to) {
    double worst = 0.0;
    constexpr int steps = 20000;
    for (int n = 0; n < steps; ++n) {
        const V x = ramp<V>(from + (to - from) * n / steps, (to - from) / steps / V::lanes);
        const V result = exp(x);
        for (int k = 0; k < V::lanes; ++k) {
            const long double exact = std::exp(static_cast<long double>(x.raw[k]));
            const double ulp = static_cast<double>(exact) * std::numeric_limits<typename V::Value>::epsilon();
            worst =
                std::max(worst, static_cast<double>(std::abs(static_cast<long double>(result.raw[k]) - exact)) / ulp);
        }
    }
    return worst;
}

}  // namespace

TEMPLATE_TEST_CASE("vectors compute lane by lane what numbers do", "", (Vec<double, 2>), (Vec<double, 4>),
                   (Vec<double, 8>), (Vec<float, 4>), (Vec<float, 8>), (Vec<float, 16>)) {
    using V = TestType;
    using T = typename V::Value;
    const V x = ramp<V>(0.3, 1.7);
    same_in_every_lane(
        x, [](V v) { return v + V(0.1); }, [](T v) { return v + T(0.1); });
    same_in_every_lane(
        x, [](V v) { return v - V(0.1); }, [](T v) { return v - T(0.1); });
    same_in_every_lane(
        x, [](V v) { return v * V(0.1); }, [](T v) { return v * T(0.1); });
    same_in_every_lane(
        x, [](V v) { return V(1) / v; }, [](T v) { return T(1) / v; });
    same_in_every_lane(
        x, [](V v) { return -v; }, [](T v) { return -v; });
    same_in_every_lane(
        x, [](V v) { return sqrt(v); }, [](T v) { return std::sqrt(v); });
    same_in_every_lane(
        x, [](V v) { return max(v, V(3)); }, [](T v) { return std::max(v, T(3)); });
    same_in_every_lane(
        x, [](V v) { return where_less(v, V(3), V(7)); }, [](T v) { return v < T(3) ? T(7) : T(0); });
    same_in_every_lane(
        x, [](V v) { return multiply_add(v, V(2), V(1)); }, [](T v) { return v * T(2) + T(1); });
    V one(1);
    V two(2);
    add_product(x, V(3), one, two);
    same_in_every_lane(
        x, [one](V) { return one; }, [](T v) { return T(1) + v * T(3); });
    same_in_every_lane(
        x, [two](V) { return two; }, [](T v) { return T(2) + v * T(3); });
    V sum = x;
    sum += x;
    same_in_every_lane(
        sum, [](V v) { return v; }, [](T v) { return v; });
    CHECK(sum.raw[1] == 2 * x.raw[1]);
}

TEMPLATE_TEST_CASE("two reciprocals by one division are within two units in the last place", "", (Vec<double, 4>),
                   (Vec<double, 8>), (Vec<float, 8>)) {
    using V = TestType;
    using T = typename V::Value;
    const T largest = std::is_same_v<T, double> ? T(1e30) : T(1e15);  // as different as squared distances in a kernel
    double worst = 0.0;
    for (T scale = T(1) / largest; scale <= largest; scale *= T(1000)) {
        const V a = V(scale) * ramp<V>(0.3, 1.7);
        const V b = ramp<V>(1.1, 0.37);
        V inverse_a;
        V inverse_b;
        by_one_division(a, b, inverse_a, inverse_b);
        for (int k = 0; k < V::lanes; ++k) {
            for (const auto& [x, inverse] : {std::pair{a, inverse_a}, std::pair{b, inverse_b}}) {
                const long double exact = 1.0L / static_cast<long double>(x.raw[k]);
                worst = std::max(worst,
                                 static_cast<double>(std::abs(static_cast<long double>(inverse.raw[k]) / exact - 1)));
            }
        }
    }
    CHECK(worst < 2.0 * static_cast<double>(std::numeric_limits<T>::epsilon()));
    CHECK(worst > 0.0);
}

TEMPLATE_TEST_CASE("what where_less leaves out is zero even if it is no number", "", (Vec<double, 2>), (Vec<double, 4>),
                   (Vec<double, 8>), (Vec<float, 4>), (Vec<float, 8>)) {
    using V = TestType;
    const V nothing = where_less(V(2), V(1), V(std::numeric_limits<double>::quiet_NaN()));
    const V none_of_nan = where_less(V(std::numeric_limits<double>::quiet_NaN()), V(1), V(5));
    for (int k = 0; k < V::lanes; ++k) {
        CHECK(nothing.raw[k] == 0);
        CHECK(none_of_nan.raw[k] == 0);
    }
}

TEMPLATE_TEST_CASE("of a number and none the larger is the second", "", (Vec<double, 2>), (Vec<double, 4>),
                   (Vec<double, 8>), (Vec<float, 4>), (Vec<float, 8>), (Vec<float, 16>)) {
    using V = TestType;
    const V none(std::numeric_limits<double>::quiet_NaN());
    const V first = max(none, V(2));
    const V second = max(V(2), none);
    for (int k = 0; k < V::lanes; ++k) {
        CHECK(first.raw[k] == 2);
        CHECK(std::isnan(second.raw[k]));
    }
}

TEST_CASE("a polynomial of any length is the sum of its terms") {
    using V = Vec<double, 4>;
    const V x = ramp<V>(-1.0, 1.0);  // all terms below are whole numbers: exact in any order
    const auto check = [&x](const auto& c, std::size_t length) {
        for (int k = 0; k < V::lanes; ++k) {
            double expected = 0.0;
            for (std::size_t n = length; n > 0; --n) {
                expected = expected * x.raw[k] + c[n - 1].raw[k];
            }
            CHECK(polynomial(c, x).raw[k] == expected);
        }
    };
    const V one[] = {V(7)};
    const V two[] = {V(7), V(5)};
    const V three[] = {V(7), V(5), V(-2)};
    const V seven[] = {V(1), V(2), V(3), V(4), V(5), V(6), V(-7)};
    const V eight[] = {V(1), V(2), V(3), V(4), V(5), V(6), V(-7), V(11)};
    check(one, 1);
    check(two, 2);
    check(three, 3);
    check(seven, 7);
    check(eight, 8);
}

TEMPLATE_TEST_CASE("a sum takes every lane once", "", (Vec<double, 2>), (Vec<double, 4>), (Vec<double, 8>),
                   (Vec<float, 4>), (Vec<float, 8>), (Vec<float, 16>)) {
    using V = TestType;
    for (int k = 0; k < V::lanes; ++k) {
        V one(0);
        one.raw[k] = 3;
        CHECK(sum(one) == 3.0);
    }
    CHECK(sum(V(1)) == V::lanes);
}

TEST_CASE("sums of single-precision lanes are made in double") {
    Vec<float, 8> v(0x1p-30);
    v.raw[0] = 1.0F;
    CHECK(sum(v) == 1.0 + 7 * 0x1p-30);
}

TEST_CASE("exp is right to two units in the last place, over the range of its numbers") {
    CHECK(worst_exp<Vec<double, 2>>(-708.0, 709.0) < 2.0);
    CHECK(worst_exp<Vec<double, 8>>(-1.0, 1.0) < 2.0);
    CHECK(worst_exp<Vec<float, 4>>(-87.0, 88.0) < 2.0);
    CHECK(worst_exp<Vec<float, 16>>(-1.0, 1.0) < 2.0);
    CHECK(exp(Vec<double, 4>(0)).raw[3] == 1.0);
    CHECK(exp(Vec<double, 4>(-1e6)).raw[0] == exp(Vec<double, 4>(-708)).raw[0]);
    CHECK(exp(Vec<float, 8>(-1e6)).raw[0] < 1e-37F);
}

TEMPLATE_TEST_CASE_SIG("lanes that are less have their bits set, and numbers whose bit is set are packed", "",
                       ((int lanes), lanes), 4, 8, 16) {
    constexpr unsigned step = lanes == 16 ? 37 : 1;
    for (unsigned wanted = 0; wanted < (1U << lanes); wanted += step) {
        simd::RawVector<float, lanes> a;
        simd::RawVector<float, lanes> b;
        std::array<std::int32_t, static_cast<std::size_t>(lanes)> numbers;
        std::vector<std::int32_t> kept;
        std::vector<std::int32_t> kept_of_even;
        for (int k = 0; k < lanes; ++k) {
            const bool is_wanted = (wanted >> k & 1U) != 0;
            a[k] = static_cast<float>(k);
            b[k] = static_cast<float>(is_wanted ? k + 1 : k);
            numbers[static_cast<std::size_t>(k)] = 100 + k;
            if (is_wanted) {
                kept.push_back(100 + k);
            }
            if (is_wanted && k % 2 == 0) {
                kept_of_even.push_back(100 + k);
            }
        }
        CHECK(simd::bits_of_less<lanes>(a, b) == wanted);
        std::array<std::int32_t, static_cast<std::size_t>(lanes)> packed;
        CHECK(simd::pack<lanes, 1>(numbers.data(), wanted, packed.data()) == static_cast<int>(kept.size()));
        CHECK(std::equal(kept.begin(), kept.end(), packed.begin()));
        CHECK(simd::pack<lanes, 2>(numbers.data(), wanted & 0x5555U, packed.data()) ==
              static_cast<int>(kept_of_even.size()));
        CHECK(std::equal(kept_of_even.begin(), kept_of_even.end(), packed.begin()));
    }
}

TEMPLATE_TEST_CASE_SIG("the smaller number of each lane", "", ((int lanes), lanes), 4, 8, 16) {
    simd::RawVector<float, lanes> a;
    simd::RawVector<float, lanes> b;
    for (int k = 0; k < lanes; ++k) {
        a[k] = static_cast<float>(k % 3);
        b[k] = 1.0F;
    }
    const auto least = simd::smaller<float, lanes>(a, b);
    for (int k = 0; k < lanes; ++k) {
        CHECK(least[k] == std::min(a[k], b[k]));
    }
}

TEMPLATE_TEST_CASE_SIG("two or four numbers are repeated over all lanes, in turn or each by itself", "",
                       ((class T, int count, int lanes), T, count, lanes), (double, 2, 2), (double, 2, 4),
                       (double, 4, 8), (std::int32_t, 2, 4), (std::int32_t, 4, 8), (std::int32_t, 4, 16)) {
    simd::RawVector<T, count> few;
    for (int k = 0; k < count; ++k) {
        few[k] = T(5 + k);
    }
    const auto in_turn = simd::repeated<T, lanes, count>(few);
    const auto each = simd::each_repeated<T, lanes, count>(few);
    for (int k = 0; k < lanes; ++k) {
        const int of = k / (lanes / count);
        CHECK(in_turn[k] == few[k % count]);
        CHECK(each[k] == few[of]);
    }
}
