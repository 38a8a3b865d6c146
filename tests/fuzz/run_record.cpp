#include "fuzz_target.hpp"
#include "ljmd/core/errors.hpp"
#include "run/recorded_run.hpp"

using namespace ljmd;

// run.json, as `ljmd resume` reads it.
LJMD_FUZZ_TARGET(run_record) {
    constexpr Index more_steps = 10;
    static const test::WrittenFile file("", "run.json");
    file.rewrite(fuzz::text_of(data, size));
    try {
        const RecordedRun run = recorded_run(file.directory(), more_steps);
        fuzz::require(run.deck.stages().back().steps >= 0, "a stage has fewer steps than none");
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    } catch (const InputError&) {
    }
    return 0;
}
