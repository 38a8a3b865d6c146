#include <algorithm>
#include <functional>
#include <map>

#include "deck/deck_fixtures.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "neighbors/pair_search.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

using Visit = std::function<void(const std::string&, const Key&)>;

void visit_keys(const Schema& schema, const std::string& path, const Visit& visit) {
    const auto visit_all = [&](const std::vector<Key>& keys) {
        for (const Key& key : keys) {
            visit(path + key.name, key);
            for (const Schema& inner : key.inner) {
                visit_keys(inner, path + key.name + ".", visit);
            }
        }
    };
    visit_all(schema.keys());
    for (const auto& selection : schema.selections()) {
        for (const auto& [choice, keys] : selection.cases) {
            visit_all(keys);
        }
    }
}

void visit_keys(const Visit& visit) {
    for (const DeckKind kind : {DeckKind::fluid, DeckKind::few_body}) {
        visit_keys(deck_schema(kind), "", visit);
    }
}

/// Every key of a deck, by its path: "stage.thermostat.every". Keys of several choices or kinds are found once.
std::map<std::string, Key> all_keys() {
    std::map<std::string, Key> keys;
    visit_keys([&](const std::string& path, const Key& key) { keys.insert({path, key}); });
    return keys;
}

Value value_of(const std::vector<double>& numbers) {
    Array array;
    for (const double number : numbers) array.push_back({number, {}});
    return {array, {}};
}
Value value_of(const auto& scalar) {
    return {scalar, {}};
}

/// The keys that must be given, as a deck writes them, all with the value 1, which every one allows.
std::string required_of(const std::vector<Key>& keys, const std::string& separator) {
    std::string text;
    for (const Key& key : keys) {
        if (key.required) {
            text += separator + key.name + " = 1";
        }
    }
    return text;
}

void check_accepted(const std::string& text) {
    for (const Diagnostic& entry : complaints(text)) {
        INFO(text << '\n' << format(entry));
        CHECK(entry.severity == Severity::warning);
    }
}

}  // namespace

TEST_CASE("every key of a deck says what it means, and what happens without it") {
    visit_keys([](const std::string& path, const Key& key) {
        INFO(path);
        CHECK_FALSE(key.meaning_text.empty());
        CHECK(key.low <= key.high);
        CHECK((key.required || key.default_value || !key.absent_text.empty()));
        CHECK((key.kind != Kind::choice || !key.choices.empty()));
        if (key.kind == Kind::number && key.physical_dimension != Dimension::none) {
            CHECK_FALSE(key.reduced_unit.empty());
        }
    });
}

TEST_CASE("every default is a value that its key allows") {
    int defaults = 0;
    visit_keys([&](const std::string& path, const Key& key) {
        if (!key.default_value) {
            return;
        }
        ++defaults;
        Diagnostics diagnostics;
        const Table table{
            {key.name, {}, std::visit([](const auto& plain) { return value_of(plain); }, *key.default_value)}};
        static_cast<void>(validate(table, {}, Schema("a table", {key}), std::nullopt, diagnostics));
        for (const Diagnostic& entry : diagnostics.entries()) {
            FAIL_CHECK(path << ": " << entry.message);
        }
    });
    CHECK(defaults > 10);
}

TEST_CASE("the names that decks are promised are there") {
    const auto keys = all_keys();
    for (const char* path : {"title",
                             "units",
                             "argon.sigma",
                             "argon.epsilon",
                             "argon.mass",
                             "system.lattice.type",
                             "system.lattice.cells",
                             "system.file",
                             "system.density",
                             "system.temperature",
                             "system.seed",
                             "potential.type",
                             "potential.cutoff",
                             "potential.truncation",
                             "potential.switch_start",
                             "potential.tail",
                             "neighbors.method",
                             "neighbors.skin",
                             "stage.name",
                             "stage.integrator",
                             "stage.time_step",
                             "stage.steps",
                             "stage.temperature",
                             "stage.thermostat.type",
                             "stage.thermostat.every",
                             "stage.sample",
                             "stage.reverse",
                             "stage.start",
                             "force.type",
                             "force.gravitational_constant",
                             "force.stiffness",
                             "body.mass",
                             "body.position",
                             "body.velocity",
                             "output.trajectory.accelerations",
                             "analysis.orbit.about",
                             "analysis.oscillation.component",
                             "analysis.closest_approach",
                             "output.directory",
                             "output.thermo.every",
                             "output.trajectory.format",
                             "output.trajectory.every",
                             "output.trajectory.velocities",
                             "analysis.rdf.bins"}) {
        INFO(path);
        CHECK(keys.count(path) == 1);
    }
}

TEST_CASE("which potential, and how it is cut off, has no silent default") {
    const auto keys = all_keys();
    for (const char* name :
         {"type", "cutoff", "truncation", "switch_start", "tail", "well_depth", "steepness", "minimum"}) {
        INFO(name);
        const Key& key = keys.at(std::string("potential.") + name);
        CHECK_FALSE(key.default_value.has_value());
        CHECK(key.required == (key.name != "tail"));  // which is asked for where it has a meaning, see check_sense
    }
}

TEST_CASE("every plug-in can be selected by its name") {
    for (const IntegratorMethod& method : all_integrators()) {
        const std::string text =
            changed(small_deck, {{"steps = 40", "integrator = \"" + method.name + "\"\nsteps = 40"}});
        if (method.unbounded_only) {
            CHECK(complaints(text).size() == 1);
        } else {
            check_accepted(text);
        }
    }
    for (const ThermostatMethod& method : all_thermostats()) {
        check_accepted(
            changed(small_deck, {{"{ type = \"rescale\", every = 5 }",
                                  "{ type = \"" + method.name + "\"" + required_of(keys_of(method), ", ") + " }"}}));
    }
    for (const std::string& name : PairPotential::formula_names()) {
        check_accepted(changed(
            small_deck,
            {{"\"lennard-jones\"", "\"" + name + "\"" + required_of(PairPotential::formula_keys(name), "\n")}}));
    }
    for (const std::string& name : PairPotential::truncation_names()) {
        const std::string tail = PairPotential::takes_tail(name) ? "\ntail = true" : "";
        Cutoff radii;
        Description keys;
        PairPotential::describe_truncation(name, keys, radii);
        check_accepted(
            changed(small_deck, {{"\"force-shifted\"", "\"" + name + "\"" + tail + required_of(keys.keys(), "\n")}}));
    }
    for (const std::string& name : pair_search_names()) {
        check_accepted(small_deck + "[neighbors]\nmethod = \"" + name + "\"\n");
    }
    for (const AnalysisMethod& method : all_analyses()) {
        check_accepted(small_deck + "[analysis]\n" + method.name + " = {" + required_of(keys_of(method), "\n") + "}\n");
    }
}

TEST_CASE("keys that belong to one choice are unknown with another") {
    const auto found = complaints(changed(small_deck, {{"\"force-shifted\"", "\"shifted\"\nswitch_start = 1.5"}}));
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Contains("'switch_start' in [potential] goes only with truncation = 'switched'"));
}

TEST_CASE("the reference page names every key") {
    const std::string page = deck_reference_page();
    CHECK(page.starts_with("# "));
    for (const auto& [path, key] : all_keys()) {
        INFO(path);
        CHECK_THAT(page, Contains("`" + key.name + "`") || Contains("[" + key.name + "]"));
    }
}
