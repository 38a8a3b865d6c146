#include "analyze/thermo_report.hpp"
#include "fuzz_target.hpp"
#include "fuzzed_decks.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/recorded_run.hpp"
#include "study/reproduction.hpp"

using namespace ljmd;

namespace {

RecordedRun run_in(const std::filesystem::path& directory) {
    Diagnostics diagnostics;
    auto deck = load_deck_text("deck.toml", fuzz::fluid.text, fuzz::fluid.settings, false, diagnostics);
    diagnostics.throw_if_errors();
    deck->directory = directory;
    return {std::move(*deck), {}, "", 1, false};
}

void report(const RecordedRun& run) {
    try {
        const ThermoReport found = thermo_report(run);
        fuzz::require(found.first_step < found.last_step && found.last_step <= total_steps(run.deck.stages()),
                      "rows of the run's steps, in their order");
        static_cast<void>(to_json(thermo_document(found).data));
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    }
}

void evaluate(const std::filesystem::path& directory) {
    try {
        static_cast<void>(evaluate_row(verlet1967_table().front(), directory).z_scores());
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    } catch (const PhysicsError&) {
    }
}

}  // namespace

// thermo.csv, as `ljmd analyze` and a reproduced table read it; that one reads the same text as its rdf.csv, too.
LJMD_FUZZ_TARGET(thermo_csv) {
    static const test::WrittenFile file("", "thermo.csv");
    static const RecordedRun run = run_in(file.directory());
    static const bool prepared = [] {
        std::ofstream(file.directory() / "results.json")
            << R"({"observables": {}, "stages": [{"sampled": true, "first_step": 4, "steps": 6}]})";
        std::filesystem::create_symlink("thermo.csv", file.directory() / "rdf.csv");
        return true;
    }();
    static_cast<void>(prepared);
    file.rewrite(fuzz::text_of(data, size));
    report(run);
    evaluate(file.directory());
    return 0;
}
