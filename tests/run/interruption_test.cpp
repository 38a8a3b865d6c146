#include "ljmd/detail/run/interruption.hpp"

#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

TEST_CASE("a run has to stop when its wall time is over, and only then") {
    CHECK_FALSE(Interruption().wanted());
    CHECK_FALSE(Interruption(1e9).wanted());
    const Interruption over(0.0);
    CHECK(over.wanted());
    try {
        over.stop(12, "runs/argon");
    } catch (const Interrupted& stopped) {
        CHECK(stopped.exit_code() == 75);
        CHECK_THAT(stopped.what(), Contains("after step 12") && Contains("ljmd resume runs/argon"));
    }
}

TEST_CASE("a run has to stop when it is asked to, and says by whom") {
    bool asked = false;
    const Interruption interruption(std::nullopt, [&asked] {
        return asked ? std::optional(StopRequest{15, "SIGTERM"}) : std::nullopt;
    });
    CHECK_FALSE(interruption.wanted());
    CHECK_THROWS_AS(interruption.stop_many_runs(), ContractViolation);
    asked = true;
    CHECK(interruption.wanted());
    CHECK(interruption.request()->signal == 15);
    CHECK(interruption.request()->exit_code() == 143);
    CHECK_THROWS_WITH(interruption.stop(3, "out"), Contains("after step 3 by SIGTERM"));
    CHECK_THROWS_AS(interruption.stop_many_runs(), Interrupted);
}
