#include "ljmd/observables/analysis.hpp"

#include <catch2/catch.hpp>

#include "ljmd/core/registry.hpp"
#include "ljmd/neighbors/verlet_list.hpp"
#include "neighbors/sample_states.hpp"
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
    state.mark_forces_current();
    const State before = state;
    for (const AnalysisMethod& method : all_analyses()) {
        CAPTURE(method.name);
        const Section section = test::analysis_section(method, {});
        CHECK(method.check(section, state.box()).empty());
        const auto analysis = method.make(section, state);
        CHECK(analysis->samples() == 0);
        CHECK(analysis->due(0));
        for (int k = 0; k < 3; ++k) {
            analysis->sample(state);
        }
        CHECK(analysis->samples() == 3);
        const DataTable table = analysis->result();
        CHECK_FALSE(table.name.empty());
        CHECK_FALSE(table.rows.empty());
        for (const auto& row : table.rows) {
            CHECK(row.size() == table.columns.size());
        }
        const State& after = state;
        CHECK(after.positions_and_ghosts() == before.positions_and_ghosts());
        CHECK(after.velocities() == before.velocities());
        CHECK(after.ids() == before.ids());
        CHECK(after.order_version() == before.order_version());
        CHECK(after.forces_are_current());
    }
}
