#include "ljmd/detail/engine/phase_seconds.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("phases add up, and each has its key in JSON") {
    const PhaseSeconds seconds{1.0, 2.0, 4.0, 8.0, 16.0, 32.0};
    CHECK(seconds.sum() == 63.0);
    double sum = 0.0;
    for (const char* key : {"force", "list", "sort", "integrate", "observe", "write"}) {
        sum += phases_data(seconds).at(key).number();
    }
    CHECK(sum == 63.0);
    CHECK(phases_data(seconds).size() == 6);
}
