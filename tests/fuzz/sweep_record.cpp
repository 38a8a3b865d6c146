#include "study/sweep_record.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "study/study_report.hpp"
#include "sweep_promises.hpp"

using namespace ljmd;

// sweep.json, as `ljmd sweep` reads it in a directory that it finds, and `ljmd info` tells of it.
LJMD_FUZZ_TARGET(sweep_record) {
    static const test::WrittenFile file("", "sweep.json");
    file.rewrite(fuzz::text_of(data, size));
    try {
        const std::optional<SweepPlan> plan = recorded_sweep(file.directory());
        fuzz::require(plan.has_value(), "a sweep where there is a record");
        fuzz::check_points(plan->points);
        fuzz::require(sweep_runs(*plan, file.directory()).size() == plan->points.values.size(), "a run for each point");
        static_cast<void>(to_json(study_report(file.directory()).data));
    } catch (const DataError&) {
    }
    return 0;
}
