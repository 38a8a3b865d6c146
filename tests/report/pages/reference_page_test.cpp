#include <filesystem>
#include <fstream>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "report/pages/study_pages.hpp"
#include "report/report.hpp"
#include "report/report_fixtures.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

/// A directory of `ljmd reference`, made up.
class MadeUpReference {
  public:
    MadeUpReference() { write("reference.json", R"({"kind": "reference"})"); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    void results(double energy) const {
        write("results.json", R"({"kind": "reference", "temperature": 1.2, "density_of_runs": 0.75, "phase": "liquid",
            "potential_energy": {"mean": )" +
                                  std::to_string(energy) + R"(, "statistical_error": 0.003,
                "systematic_error": 0.004, "total_error": 0.005, "cutoff_correction": -0.001, "size_correction": 0.0,
                "independent_samples": 900, "equation_of_state": -5.0, "unit": "epsilon",
                "equations_of_state": {"thol2016": -5.0, "kolafa-nezbeda1994": -5.0}},
            "viscosity": {"mean": 1.9, "statistical_error": 0.1, "systematic_error": null, "total_error": null,
                "cutoff_correction": 0, "size_correction": 0, "independent_samples": 400, "equation_of_state": null,
                "equations_of_state": {}, "unit": "epsilon tau/sigma^3"},
            "warnings": ["a warning"], "citation": "words to cite"})");
    }
    [[nodiscard]] std::filesystem::path path() const { return folder_ / ""; }

  private:
    test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("the page of a reference has its values with both errors, and the equation of state beside them") {
    const MadeUpReference reference;
    reference.results(-5.01);
    reference.write("rdf.csv", "r,g\n1.0,2.0\n1.1,2.5\n");
    const PageContent page = report_on(reference.path());
    CHECK_THAT(page.title, Contains("T = 1.2, rho = 0.75: liquid"));
    REQUIRE(page.quantities.size() == 2);
    CHECK(page.quantities[0].name == "potential_energy");
    CHECK(page.quantities[0].error == 0.005);
    CHECK(page.quantities[0].reference == -5.0);
    CHECK(page.quantities[1].error == 0.1);  // the statistical one: the other is not assessed
    CHECK_FALSE(page.quantities[1].reference);
    CHECK(page.warnings == std::vector<std::string>{"a warning"});
    CHECK(page.kind == "reference");
    REQUIRE(page.tables.size() == 4);
    CHECK(page.tables[0].has_column("systematic_error"));
    test::check_marks(page);
    REQUIRE(page.charts.size() == 3);
    CHECK(page.charts[0].id == "apart");
    CHECK(page.tables[1].values.at(1).at(0).number() == Approx(-2.0));
    CHECK(page.charts[1].id == "errors");  // of the energy both, of the viscosity the statistical one
    CHECK(page.tables[2].values.at(2).size() == 3);
    CHECK(page.tables[2].values.at(2).at(1).number() == Approx(0.0798403));
    CHECK(page.charts[2].id == "rdf");
    CHECK(page.provenance.at(1) == std::pair<std::string, std::string>("density of the runs", "0.75"));
}

TEST_CASE("a value far from the equations of state is a doubt") {
    const MadeUpReference reference;
    const auto level = [&](double energy) {
        reference.results(energy);
        return reference_page(reference.path()).verdicts.back();
    };
    CHECK(level(-5.014).level == "good");
    CHECK(level(-5.016).level == "doubt");
    CHECK_THAT(level(-5.016).words, Contains("potential_energy (-3.2 errors)"));
}

TEST_CASE("a reference that has no values yet has a page all the same, and one with damaged values says so") {
    const MadeUpReference reference;
    CHECK(reference_page(reference.path()).quantities.empty());
    reference.write("results.json", "{");
    CHECK(reference_page(reference.path()).warnings.size() == 1);
}
