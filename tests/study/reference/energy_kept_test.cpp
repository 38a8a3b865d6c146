#include "study/reference/energy_kept.hpp"

#include <fstream>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("what the energy drifts goes into the temperature, in the worst run") {
    const TemporaryFolder folder;
    std::vector<std::filesystem::path> runs;
    for (const char* drift : {"0.0", "-3e-4", "null"}) {
        runs.push_back(folder / fmt::format("run-{}", runs.size()));
        std::filesystem::create_directory(runs.back());
        std::ofstream(runs.back() / "results.json")
            << R"({"stages": [{"sampled": false, "steps": 1000, "time_step": 0.005, "energy_drift": 1.0},
                   {"sampled": true, "steps": 10000, "time_step": 0.004, "energy_drift": )"
            << drift << R"(, "time_step_error": 0.001}]})";
    }
    CHECK(temperature_uncertainty(runs, 2.0) == Approx(3e-4 * 40.0 / 2.0 / 3.0 + 0.001).epsilon(1e-12));
    CHECK(temperature_uncertainty({runs[2]}, 2.0) == 0.001);
    runs.push_back(folder / "missing");
    CHECK_THROWS_AS(temperature_uncertainty(runs, 2.0), DataError);
}

TEST_CASE("an uncertain temperature is told in terms of what was asked for, not of how runs are made") {
    CHECK(energy_warning(noticeable_uncertainty).empty());
    CHECK_THAT(energy_warning(0.01),
               Contains("uncertain by 1 %") && !Contains("none is given") && !Contains("time step"));
    CHECK_THAT(energy_warning(0.03), Contains("uncertain by 3 %, and none is given"));
}
