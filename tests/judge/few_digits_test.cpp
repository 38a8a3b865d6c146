#include "judge/few_digits.hpp"

#include <cmath>
#include "catch.hpp"

using namespace ljmd;

namespace {

std::vector<Vec3> numbers_through(const std::function<double(double)>& way) {
    std::vector<Vec3> made;
    for (int k = 1; k < 10; ++k) {
        const Vec3 full(std::sin(3.0 * k), 5.0 * std::cos(7.0 * k), 300.0 * std::sin(11.0 * k));
        made.emplace_back(full.unaryExpr(way));
    }
    return made;
}

}  // namespace

TEST_CASE("numbers that went through few digits are known by them, and full ones are not") {
    for (const Rounding& way : roundings()) {
        CHECK(digits_of(numbers_through(way.round)) == way.words);
    }
    CHECK_FALSE(digits_of(numbers_through([](double x) { return x; })));
    CHECK_FALSE(digits_of({Vec3(1.0, 2.0, 0.5), Vec3::Zero()}));  // by chance
}
