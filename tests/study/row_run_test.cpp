#include "study/row_run.hpp"

#include "io/files/claimed_file.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

// Rows are run by tests/cli/reproduces.py and workers.py: their runs are processes of the program.

TEST_CASE("a prepared table says which rows are wanted, and how long their runs are") {
    const TemporaryFolder folder;
    const OpenDirectory out(folder / "");
    CHECK_FALSE(recorded_reproduction(folder / "").has_value());
    const std::vector<VerletRow> table = verlet1967_table();
    prepare_reproduction({{table[3], table[7]}, true}, out);
    const auto plan = recorded_reproduction(folder / "");
    REQUIRE(plan.has_value());
    CHECK(plan->quick);
    CHECK(plan->length().production == ReproductionLength::quick().production);
    REQUIRE(plan->rows.size() == 2);
    CHECK(row_name(plan->rows[1]) == row_name(table[7]));
    std::vector<RowRun> runs = row_runs(*plan, folder / "");
    for (RowRun& run : runs) {
        CHECK(content_of(run.run().deck) == run.run().source);
        CHECK_NOTHROW(run.check(false));
        REQUIRE(run.begin().has_value());
        CHECK_FALSE(run.after(5).has_value());
        CHECK_THAT(run.failure(), Contains(": exit code 5: "));
        CHECK_FALSE(run.result().has_value());
    }
}

TEST_CASE("while workers run rows, no others are asked for in their directory") {
    const TemporaryFolder folder;
    const OpenDirectory out(folder / "");
    const std::vector<VerletRow> table = verlet1967_table();
    const ReproductionPlan plan{{table[3]}, true};
    prepare_reproduction(plan, out);
    std::optional<SharedDirectory> worker(folder / rows_folder);
    CHECK_NOTHROW(prepare_reproduction(plan, out));
    const ReproductionPlan other{{table[3]}, false};
    CHECK_THROWS_AS(prepare_reproduction(other, out), InUseError);
    CHECK(recorded_reproduction(folder / "")->quick);
    worker.reset();
    prepare_reproduction(other, out);
    CHECK_FALSE(recorded_reproduction(folder / "")->quick);
}

TEST_CASE("a record of a table that ljmd cannot have written is refused") {
    const TemporaryFolder folder;
    for (const char* text : {"{", "{}", R"({"table": "rahman1964", "quick": true, "rows": []})",
                             R"({"table": "verlet1967", "quick": 1, "rows": []})",
                             R"({"table": "verlet1967", "quick": true, "rows": ["rho9.9000-T9.999"]})"}) {
        std::ofstream(folder / "reproduction.json") << text;
        CHECK_THROWS_AS(recorded_reproduction(folder / ""), DataError);
    }
}
