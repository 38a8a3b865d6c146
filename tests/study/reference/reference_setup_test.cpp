#include "study/reference/reference_setup.hpp"

#include <functional>

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "study/reference/made_reference.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

ReferenceRequest request_at(double temperature, double density) {
    ReferenceRequest request = liquid_request();
    request.temperature = temperature;
    request.density = density;
    return request;
}

}  // namespace

TEST_CASE("a liquid has 864 atoms, a long cutoff that is switched off, and default errors") {
    const ReferenceSetup setup = reference_setup(request_at(0.722, 0.8442));
    CHECK(setup.atoms == 864);
    CHECK(setup.phase.phase == FluidPhase::liquid);
    CHECK(setup.potential.cutoff().radius == 4.0);
    CHECK(setup.potential.cutoff().switch_start == 3.5);
    CHECK(setup.counted_radius() == Approx(5.038));
    CHECK(setup.time_step == 0.005);
    REQUIRE(setup.request.errors.size() == 2);
    CHECK(setup.request.errors[0].error == Approx(0.00608).epsilon(1e-3));
    CHECK(setup.request.errors[1].error == Approx(0.01 * 0.8442 * 0.722));
    CHECK(reference_setup(request_at(8.0, 0.5)).time_step == Approx(0.0025));
}

TEST_CASE("a compressible fluid has more atoms, and near the critical point none are enough") {
    CHECK(reference_setup(request_at(2.5, 0.3)).atoms == 864);
    const ReferenceSetup compressible = reference_setup(request_at(1.5, 0.31));
    CHECK(compressible.atoms == 2916);
    CHECK(compressible.potential.cutoff().radius == 6.0);
    CHECK(compressible.counted_radius() == 8.0);
    CHECK_THROWS_WITH(reference_setup(request_at(1.34, 0.31)), Contains("too near the critical point"));
}

TEST_CASE("what cannot be vouched for is refused with the reason") {
    CHECK_THROWS_WITH(reference_setup(request_at(1.0, 0.3)), Contains("separates into vapour and liquid"));
    CHECK_THROWS_WITH(reference_setup(request_at(0.8, 1.1)), Contains("the crystal is the stable phase"));
    CHECK_THROWS_WITH(reference_setup(request_at(0.5, 0.001)), Contains("outside of 0.661 to 9"));
    CHECK_THROWS_WITH(reference_setup(request_at(0.9, 0.74)),
                      Contains("metastable liquid") && Contains("--metastable"));
    CHECK_THROWS_WITH(reference_setup(request_at(1.5, 1e-4)), Contains("hardly meet") && Contains("virial"));
    ReferenceRequest metastable = request_at(0.9, 0.74);
    metastable.metastable = true;
    CHECK(reference_setup(metastable).phase.phase == FluidPhase::metastable_liquid);
}

TEST_CASE("a request that makes no sense is refused") {
    const auto refused = [](const std::function<void(ReferenceRequest&)>& change) {
        ReferenceRequest request = liquid_request();
        change(request);
        try {
            static_cast<void>(reference_setup(request));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(refused([](auto& r) { r.density.reset(); }), Contains("a density or a pressure"));
    CHECK_THAT(refused([](auto& r) { r.pressure = 1.0; }), Contains("a density or a pressure"));
    CHECK_THAT(refused([](auto& r) { r.temperature = 0.0; }), Contains("temperature 0"));
    CHECK_THAT(refused([](auto& r) { r.density = -1.0; }), Contains("density -1"));
    CHECK_THAT(refused([](auto& r) { r.atoms = 100; }), Contains("100 atoms"));
    CHECK_THAT(refused([](auto& r) { r.atoms = 32; }), Contains("32 atoms"));
    CHECK_THAT(refused([](auto& r) { r.replicas = 1; }), Contains("1 replicas"));
    CHECK_THAT(refused([](auto& r) { r.errors = {{"diffusion", 0.1}}; }), Contains("not among the properties"));
    CHECK_THAT(refused([](auto& r) { r.errors = {{"pressure", 0.0}}; }), Contains("the error of pressure"));
    CHECK_THAT(refused([](auto& r) { r.errors = {{"pressure", 0.1}, {"pressure", 0.2}}; }), Contains("twice"));
    CHECK_THAT(refused([](auto& r) {
                   r.properties.emplace_back("rdf");
                   r.errors = {{"rdf", 0.1}};
               }),
               Contains("is a table"));
    CHECK_THAT(refused([](auto& r) {
                   r.density = 0.95;
                   r.temperature = 2.0;
                   r.atoms = 108;
               }),
               Contains("take more atoms"));
}

TEST_CASE("a pressure stands for the density of the stable phase") {
    ReferenceRequest request = liquid_request();
    request.density.reset();
    request.pressure = 1.0;
    const ReferenceSetup setup = reference_setup(request);
    CHECK(properties(equation_of_state("thol2016"), 1.2, setup.density).pressure == Approx(1.0));
}

TEST_CASE("the decks of a reference are right, and measure what is asked for") {
    ReferenceRequest request = liquid_request();
    const auto analyses = [](const std::string& text) {
        const DeckFolder folder(text);
        std::vector<std::string> names;
        const Deck deck = folder.load();
        for (const auto& asked : deck.fluid().analysis.asked) {
            names.push_back(asked.name);
        }
        return names;
    };
    CHECK(analyses(pilot_deck(reference_setup(request))).empty());
    CHECK(analyses(canonical_deck(reference_setup(request), 2000)) ==
          std::vector<std::string>{"cutoff_correction", "rdf"});
    for (const ReferenceProperty& property : reference_properties()) {
        request.properties.emplace_back(property.name);
    }
    const ReferenceSetup all = reference_setup(request);
    CHECK(analyses(canonical_deck(all, 2000)) == std::vector<std::string>{"chemical_potential", "cutoff_correction",
                                                                          "rdf", "response_functions",
                                                                          "structure_factor"});
    CHECK(analyses(transport_deck(all, 2000, -2.0)).size() == 4);
    const DeckFolder folder(transport_deck(all, 2000, -2.0));
    const Deck deck = folder.load();
    CHECK(deck.stages().back().total_energy == -2.0);
    CHECK_FALSE(deck.stages().back().thermostat);
    CHECK(deck.stages().back().steps == first_steps(all, true));
    CHECK(deck.stages().at(1).steps == 2000);
}

TEST_CASE("no run is longer than is allowed") {
    ReferenceRequest request = request_at(1.5, 0.01);
    request.properties.insert(request.properties.end(), {"viscosity", "heat_capacity_cv"});
    request.max_steps = 3000;
    const ReferenceSetup setup = reference_setup(request);
    CHECK(first_steps(setup, false) == 3000);
    CHECK(first_steps(setup, true) == 3000);
    const DeckFolder folder(transport_deck(setup, 1000, -0.1));
    CHECK(folder.load().stages().back().steps == 3000);
}

TEST_CASE("a thin gas is followed for many times between collisions") {
    ReferenceRequest thin = request_at(1.5, 0.01);
    thin.properties.emplace_back("viscosity");
    CHECK(first_steps(reference_setup(thin), true) > 10 * first_steps(reference_setup(liquid_request()), true));
}
