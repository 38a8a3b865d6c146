
#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "deck/deck_schema.hpp"
#include "forces/few_body_force.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "neighbors/pair_search.hpp"
#include "observables/few_body/few_body_analysis.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("info names every plug-in, with keys it is the reference page") {
    const std::string text = said([] { command({"info"}); }).out;
    for (const auto& names :
         {PairPotential::formula_names(), PairPotential::truncation_names(), pair_search_names(),
          plugin_names(all_few_body_forces()), plugin_names(all_integrators()), plugin_names(all_thermostats()),
          plugin_names(all_barostats()), plugin_names(all_analyses()), plugin_names(all_few_body_analyses()),
          plugin_names(all_equations_of_state()), plugin_names(all_trajectory_formats())}) {
        for (const std::string& name : names) {
            CHECK_THAT(text, Contains(name));
        }
    }
    CHECK(said([] { command({"info", "--keys"}); }).out == deck_reference_page());
    CHECK(said([] { command({"info", "--schema"}); }).out == deck_json_schema());
}

TEST_CASE("info as JSON has the lists that scripts go through, integrators with what they promise") {
    const Data json = parse_json(said([] { command({"info", "--json"}); }).out);
    CHECK(json.at("version") == build_info().version);
    CHECK(json.at("commit") == build_info().commit);
    CHECK(json.at("potentials") == Data(PairPotential::formula_names()));
    CHECK(json.at("truncations") == Data(PairPotential::truncation_names()));
    CHECK(json.at("pair_searches") == Data(pair_search_names()));
    CHECK(json.at("forces") == Data(plugin_names(all_few_body_forces())));
    CHECK(json.at("thermostats") == Data(plugin_names(all_thermostats())));
    CHECK(json.at("barostats") == Data(plugin_names(all_barostats())));
    CHECK(json.at("analyses") == Data(plugin_names(all_analyses())));
    CHECK(json.at("few_body_analyses") == Data(plugin_names(all_few_body_analyses())));
    CHECK(json.at("equations_of_state") == Data(plugin_names(all_equations_of_state())));
    CHECK(json.at("trajectory_formats") == Data(plugin_names(all_trajectory_formats())));
    const auto methods = all_integrators();
    REQUIRE(json.at("integrators").size() == methods.size());
    for (std::size_t k = 0; k < methods.size(); ++k) {
        const Data& integrator = json.at("integrators")[k];
        CHECK(integrator.at("name") == methods[k].name);
        CHECK(integrator.at("meaning") == methods[k].meaning);
        CHECK(integrator.at("order") == methods[k].order);
        CHECK(integrator.at("reversible") == methods[k].reversible);
    }
}
