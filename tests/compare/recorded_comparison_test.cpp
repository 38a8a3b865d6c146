#include "compare/recorded_comparison.hpp"

#include <fstream>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a directory with comparisons is told in a few lines") {
    const TemporaryFolder folder;
    CHECK_FALSE(holds_comparison(folder / ""));
    CHECK_FALSE(holds_comparison(folder / "missing"));
    CHECK_THROWS_AS(comparison_report(folder / ""), DataError);
    std::ofstream(folder / "judge.json") << R"({"deck": "a.toml", "with": "files:x", "peer": "mine", "passed": false,
        "checks": [{"name": "virial", "passed": false}, {"name": "forces", "passed": true}],
        "diagnoses": ["virial: the sign is wrong"]})";
    std::ofstream(folder / "compare-gsl.json") << R"({"deck": "b.toml", "with": "gsl", "passed": true,
        "checks": [{"name": "energy", "passed": true}]})";
    std::ofstream(folder / "compare-gsl.csv") << "step\n";
    CHECK(holds_comparison(folder / ""));
    const Document found = comparison_report(folder / "");
    CHECK_THAT(found.text, Contains("b.toml against gsl\nverdict       all 1 checks passed\n"));
    CHECK_THAT(found.text, Contains("a.toml against mine\nverdict       1 of 2 checks FAILED\nfailed        virial\n"
                                    "diagnosis     virial: the sign is wrong\n"));
    CHECK(found.data.at("comparisons").size() == 2);
    CHECK(found.data.at("comparisons")[1].at("failed")[0].text() == "virial");
    std::ofstream(folder / "judge.json") << "{}";
    CHECK_THROWS_AS(comparison_report(folder / ""), DataError);
}
