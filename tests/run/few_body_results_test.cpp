#include <cmath>
#include <limits>

#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "run/results.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

FewBodyResult some_result() {
    return {.bodies = 2,
            .dimensions = 2,
            .force = "newtonian-gravity",
            .histories = {{"total_energy", -0.205, -0.2050001, -0.20500005, 1e-7},
                          {"momentum_x", 0.0, std::nan(""), 0.0, std::numeric_limits<double>::infinity()}},
            .stages = {{"orbits", "velocity-verlet", 0, 95, 0.01, true, false, false, 2.5e-9, "xxh3:a", "xxh3:b"}},
            .findings = {{"closest_approach", {}},
                         {"orbit",
                          {{"period", 2.9917, 0.0012},
                           {"precession", 0.1, std::nan("")},
                           {"semi_major_axis_at_end", 0.6097, std::nullopt}}}},
            .tables = {},
            .seconds = 1.0};
}

}  // namespace

TEST_CASE("results.json of few bodies has the keys that scripts rely on") {
    const Data json = parse_json(to_json(results_report(DeckFolder(stars_deck).load(), some_result()).data));
    CHECK(json.at("title") == "Two stars");
    CHECK(json.at("system") ==
          Data::object({{"kind", "few-body"}, {"bodies", 2}, {"dimensions", 2}, {"force", "newtonian-gravity"}}));
    CHECK(json.at("observables").at("total_energy") == Data::object({{"mean", -0.20500005},
                                                                     {"standard_error", nullptr},
                                                                     {"at_start", -0.205},
                                                                     {"at_end", -0.2050001},
                                                                     {"largest_deviation", 1e-7},
                                                                     {"unit", "the deck's own"}}));
    CHECK(json.at("analysis").at("orbit").at("period") ==
          Data::object({{"value", 2.9917}, {"standard_error", 0.0012}}));
    CHECK(json.at("analysis").at("orbit").at("semi_major_axis_at_end").at("standard_error").is_null());
    CHECK(json.at("analysis").at("closest_approach") == Data::object());
    REQUIRE(json.at("stages").size() == 1);
    CHECK(json.at("stages")[0].at("name") == "orbits");
    CHECK(json.at("stages")[0].at("checksum_at_end") == "xxh3:b");
    CHECK(json.at("warnings") == Data::list());
}

TEST_CASE("what is no number is null in results.json of few bodies") {
    const Data json = parse_json(to_json(results_report(DeckFolder(stars_deck).load(), some_result()).data));
    CHECK(json.at("observables").at("momentum_x").at("at_end").is_null());
    CHECK(json.at("observables").at("momentum_x").at("largest_deviation").is_null());
    CHECK(json.at("analysis").at("orbit").at("precession") ==
          Data::object({{"value", 0.1}, {"standard_error", nullptr}}));
}

TEST_CASE("the table of a few-body run shows totals, findings and drift") {
    const Deck deck = DeckFolder(stars_deck).load();
    FewBodyResult result = some_result();
    result.histories.pop_back();
    const std::string table = results_report(deck, result).text;
    CHECK_THAT(table, Catch::StartsWith("Two stars\n2 bodies in 2 dimensions, force newtonian-gravity\n\n") &&
                          Contains("\n  total_energy        -0.205  -0.2050001              1e-07\n") &&
                          Contains("\n  closest_approach\n") && Contains("2.9917  +- 0.0012\n") && !Contains("nan") &&
                          Contains("semi_major_axis_at_end") && Contains("0.6097\n") &&
                          Contains("energy drift in stage 'orbits': 2.5e-09 per unit of time\n") &&
                          Catch::EndsWith("files: " + deck.directory.string() + "\n"));
    result.bodies = 1;
    result.dimensions = 1;
    CHECK_THAT(results_report(deck, result).text, Contains("1 body in 1 dimension,"));
}
