#include "ljmd/app/wait_policy.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "core/environment_guard.hpp"

using namespace ljmd;

TEST_CASE("one thread waits for nobody, and what the user says of waiting is left alone") {
    // Both calls come back: nothing is started again.
    char* arguments[] = {nullptr};
    wait_actively(1, arguments);
    const test::EnvironmentGuard passive("OMP_WAIT_POLICY", "passive");
    wait_actively(8, arguments);
    CHECK(std::string(std::getenv("OMP_WAIT_POLICY")) == "passive");
}
