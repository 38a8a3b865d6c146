#include "judge/engine_speed.hpp"

#include <vector>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("speeds have no start-up in them, and one slow round changes nothing") {
    std::vector<Index> asked;
    int calls = 0;
    const auto theirs = [&](Index steps) {
        asked.push_back(steps);
        return 0.75 + 0.001 * static_cast<double>(steps) + (++calls == 3 ? 50.0 : 0.0);
    };
    const auto ours = [](Index steps) { return 1e-5 * static_cast<double>(steps); };
    const auto found = compare_speed(ours, theirs, 1000, 7);
    REQUIRE(found);
    CHECK(found->ours == Approx(1e5));
    CHECK(found->theirs == Approx(1000.0));
    CHECK(found->start_up == Approx(0.75));
    CHECK(asked == std::vector<Index>{196, 1000, 196, 1000, 196, 1000});
}

TEST_CASE("a run that takes no longer for more steps has no speed") {
    CHECK_FALSE(
        compare_speed([](Index) { return 1.0; }, [](Index steps) { return static_cast<double>(steps); }, 100, 5));
    CHECK_FALSE(
        compare_speed([](Index steps) { return static_cast<double>(steps); }, [](Index) { return 1.0; }, 100, 5));
}
