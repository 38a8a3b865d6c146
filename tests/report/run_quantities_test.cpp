#include "report/run_quantities.hpp"

#include <fstream>

#include "ljmd/detail/reference/equation_of_state.hpp"
#include "report/reference_errors.hpp"
#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::vector<std::string> full_fluid{"potential.cutoff=2.5", "potential.truncation=cut", "potential.tail=true"};

}  // namespace

TEST_CASE("quantities are those of results.json, to the last bit, without those that tables leave out") {
    const DeckFolder folder;
    const Deck deck = folder.load({"argon.sigma=3.405 angstrom", "argon.epsilon=119.8 K", "argon.mass=39.948 u"});
    run_whole(deck);
    const RunFacts facts = run_facts(deck.directory);
    const std::vector<Quantity> quantities = run_quantities(facts, std::nullopt);
    const Data& pressure = facts.results["observables"]["pressure"];
    const Quantity& found = quantity_called(quantities, "pressure");
    CHECK(found.value == pressure["mean"].number());
    CHECK(found.value_in_si == pressure["si"]["mean"].number());
    CHECK(found.si_unit == "bar");
    CHECK(found.symbol == "p");
    CHECK(std::ranges::find(quantities, "virial", &Quantity::name) == quantities.end());
    CHECK(std::ranges::find(quantities, "pressure_xy", &Quantity::name) == quantities.end());
}

TEST_CASE("while there are no results, quantities are means of the rows so far") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.thermo.every=2"});
    run_until(deck, 50);
    const RunFacts facts = run_facts(deck.directory);
    const ThermoReport report = thermo_report(*facts.run);
    CHECK(quantity_called(run_quantities(facts, report), "temperature").value ==
          report.columns[0].of_all.estimate->mean);
    CHECK(run_quantities(facts, std::nullopt).empty());
}

TEST_CASE("an equation of state of the same fluid stands beside, with the error of the measured temperature") {
    const DeckFolder folder;
    const Deck deck = folder.load(full_fluid);
    std::vector<Quantity> quantities{{.name = "temperature", .value = 2.0, .error = 0.01},
                                     {.name = "pressure", .value = 1.0, .error = 0.1}};
    CHECK(add_references(quantities, deck, 0.5, folder / "") == "thol2016");
    const EquationOfState equation = equation_of_state("thol2016");
    CHECK(quantities[1].reference == properties(equation, 2.0, 0.5).pressure);
    const double of_temperature = 0.01 * properties(equation, 2.0, 0.5).pressure_temperature_slope;
    const double of_equation = difference_of_equations(equation, 2.0, 0.5, &FluidProperties::pressure);
    CHECK(of_equation > 0.0);
    CHECK(quantities[1].reference_error.value() == Approx(std::hypot(of_temperature, of_equation)).epsilon(0.01));
    CHECK_FALSE(quantities[0].reference);

    // With g(r) beyond the cutoff, what it does there counts, too.
    DataTable rdf{"rdf", {"r", "g"}, {}};
    std::ofstream file(folder / "rdf.csv");
    file << "r,g\n";
    for (int bin = 0; bin < 40; ++bin) {
        const double r = 0.1 * bin + 0.05;
        rdf.rows.push_back({r, r < 2.5 ? 0.0 : 1.5});
        file << r << ',' << rdf.rows.back()[1] << '\n';
    }
    file.close();
    const double of_cutoff = beyond_cutoff(rdf, 2.5, 0.5)->pressure;
    CHECK(add_references(quantities, deck, 0.5, folder / "") == "thol2016");
    CHECK(std::abs(of_cutoff) > of_equation);
    CHECK(quantities[1].reference_error.value() ==
          Approx(std::hypot(of_temperature, of_equation, of_cutoff)).epsilon(0.01));
}

TEST_CASE("where no equation holds, the reason is told") {
    const DeckFolder folder;
    std::vector<Quantity> two_phases{{.name = "temperature", .value = 0.8, .error = 0.01},
                                     {.name = "pressure", .value = 1.0}};
    CHECK_THAT(add_references(two_phases, folder.load(full_fluid), 0.3, folder / ""), Contains("not reliable here"));
    CHECK_FALSE(two_phases[1].reference);
    CHECK_THAT(add_references(two_phases, folder.load(), 0.8, folder / ""),
               Contains("no equation of state of exactly this fluid"));
    std::vector<Quantity> none;
    CHECK_THAT(add_references(none, folder.load(full_fluid), 0.8, folder / ""), Contains("no state"));
}
