#include "ljmd/detail/observables/analysis.hpp"

#include <algorithm>
#include <cmath>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "execution/test_execution.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"
#include "neighbors/verlet_list.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

TEST_CASE("analyses are listed by name, in alphabetical order, with a meaning") {
    const auto methods = all_analyses();
    const std::vector<std::string> names = plugin_names(methods);
    CHECK(std::is_sorted(names.begin(), names.end()));
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    CHECK(std::find(names.begin(), names.end(), "rdf") != names.end());
    for (const auto& method : methods) {
        CHECK_FALSE(method.meaning.empty());
    }
}

TEST_CASE("every analysis works with its defaults and leaves the state untouched to the last bit") {
    State state = test::shaken_crystal(3, 0.8442, 0.2, 12);
    VerletList list(0.3);
    list.prepare(state, 2.5);
    std::mt19937_64 generator(1);
    test::displace(state, 0.05, generator);
    draw_velocities(state, 1.0, 3);
    state.mark_forces_current();
    const State before = state;
    for (const AnalysisMethod& method : all_analyses()) {
        CAPTURE(method.name);
        const auto options = test::analysis_options(method);
        const SampledRun run = test::run_of(state);
        CHECK(options->check(run).empty());
        const auto analysis = options->make(run);
        CHECK(analysis->samples() == 0);
        CHECK(analysis->tables().empty());
        CHECK(analysis->observables().empty());
        CHECK(analysis->due(0));
        Index due = 0;
        for (Index step = 1; step <= run.steps; ++step) {
            if (analysis->due(step)) {
                analysis->sample(state, {});
                ++due;
            }
        }
        CHECK(analysis->samples() == due);
        std::vector<std::string> names;
        for (const DataTable& table : analysis->tables()) {
            names.push_back(table.name);
            CHECK_FALSE(table.rows.empty());
            for (const auto& row : table.rows) {
                CHECK(row.size() == table.columns.size());
            }
        }
        CHECK(names == method.files);
        const State& after = state;
        CHECK(after.positions_and_ghosts() == before.positions_and_ghosts());
        CHECK(after.velocities() == before.velocities());
        CHECK(after.ids() == before.ids());
        CHECK(after.order_version() == before.order_version());
        CHECK(after.forces_are_current());
    }
}

TEST_CASE("every analysis goes on from an archive, and with any number of threads, to the same bits") {
    for (const AnalysisMethod& method : all_analyses()) {
        CAPTURE(method.name);
        const auto found = [&method](int threads, Index archived_at) {
            State state = test::shaken_crystal(3, 0.8442, 0.2, 12, test::with_threads(threads));
            draw_velocities(state, 1.0, 3);
            const SampledRun run = test::run_of(state);
            const auto options = test::analysis_options(method);
            auto analysis = options->make(run);
            std::mt19937_64 generator(1);
            for (Index step = 1; step <= run.steps; ++step) {
                if (step == archived_at) {
                    auto restored = options->make(run);
                    test::through_archive(*analysis, *restored);
                    analysis = std::move(restored);
                }
                if (analysis->due(step)) {
                    test::displace(state, 0.02, generator);
                    draw_velocities(state, 1.0, static_cast<std::uint64_t>(step));
                    state.step = step;
                    Evaluation evaluation;
                    evaluation.virial = state.velocities().leftCols<3>();
                    analysis->sample(state, evaluation);
                }
            }
            std::vector<double> numbers;
            for (const DataTable& table : analysis->tables()) {
                for (const auto& row : table.rows) {
                    numbers.insert(numbers.end(), row.begin(), row.end());
                }
            }
            for (const ObservableAverage& observable : analysis->observables()) {
                if (!observable.estimate) {
                    CHECK_FALSE(observable.remark.empty());
                    numbers.push_back(-2.0);
                    continue;
                }
                numbers.push_back(observable.estimate->mean);
                numbers.push_back(observable.estimate->standard_error);
            }
            // Numbers that are not known are the same, too.
            std::ranges::replace_if(
                numbers, [](double x) { return std::isnan(x); }, -1.0);
            return numbers;
        };
        const auto whole = found(1, 0);
        CHECK_FALSE(whole.empty());
        CHECK(found(3, 0) == whole);
        CHECK(found(1, 5555) == whole);
    }
}
