#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "study/sweep_points.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Values = std::vector<std::string>;

namespace {

SweepPoints read(const std::string& text, Diagnostics& diagnostics, const std::vector<std::string>& settings = {}) {
    const TemporaryFolder folder;
    std::ofstream(folder / "points.csv", std::ios::binary) << text;
    return list_points(folder / "points.csv", settings, diagnostics);
}

/// What a list is complained of, without the folder.
Values sweep_complaints(const std::string& text, const std::vector<std::string>& settings = {}) {
    Diagnostics diagnostics;
    CHECK(read(text, diagnostics, settings).values.empty());
    CHECK(diagnostics.has_errors());
    Values found;
    for (const Diagnostic& entry : diagnostics.entries()) {
        const std::string message = format(entry);
        found.push_back(message.substr(message.find("points.csv")));
    }
    return found;
}

}  // namespace

TEST_CASE("each row of a list is a point") {
    Diagnostics diagnostics;
    const SweepPoints points = read(
        "\xEF\xBB\xBFsystem.temperature, system.lattice\r\n1.20,\"{ type = \"\"fcc\"\", cells = 3 "
        "}\"\r\n\r\n86.5 K ,\xC3\x85",
        diagnostics);
    CHECK_FALSE(diagnostics.has_errors());
    CHECK(points.keys == Values{"system.temperature", "system.lattice"});
    CHECK(points.values == std::vector<Values>{{"1.20", "{ type = \"fcc\", cells = 3 }"}, {"86.5 K", "\xC3\x85"}});
}

TEST_CASE("every row that is no point is told of with its line") {
    const Values found = sweep_complaints("a,b\n1,2\n1\n\n1,2,3\n1,\n\"1,2\n1 ,2\n3,4\n");
    REQUIRE(found.size() == 5);
    CHECK_THAT(found[0], Contains("points.csv:3:1: 1 fields, but 2 keys in the header\n  3 | 1\n"));
    CHECK_THAT(found[1], Contains("points.csv:5:1: 3 fields, but 2 keys in the header"));
    CHECK_THAT(found[2], Contains("points.csv:6:1: no value of 'b'"));
    CHECK_THAT(found[3], Contains("points.csv:7:1: a quote is left open"));
    CHECK_THAT(found[4], Contains("points.csv:8:1: the same point as in line 2"));
}

TEST_CASE("a header that is wrong is the only complaint") {
    CHECK_THAT(sweep_complaints("a,a\n1\n2\n").at(0), Contains("points.csv:1:1: the key 'a' stands twice"));
    CHECK(sweep_complaints("a,a\n1\n2\n").size() == 1);
    CHECK_THAT(sweep_complaints("\"a\n1\n").at(0), Contains("points.csv:1:1: a quote is left open"));
    CHECK(sweep_complaints("\"a\n1\n").size() == 1);
    CHECK_THAT(sweep_complaints("a,\n1,2\n").at(0), Contains("'' is no key of a deck"));
    CHECK_THAT(sweep_complaints("a=1\n1\n").at(0), Contains("'a=1' is no key of a deck"));
    CHECK_THAT(sweep_complaints("a,b\n1,2\n", {"b=2"}).at(0), Contains("'b' is varied, and given by --set as well"));
}

TEST_CASE("a list without points, or with too many, is refused") {
    for (const char* text : {"", "\n \n", "a,b\n", "a,b\n\n"}) {
        INFO(text);
        CHECK_THAT(sweep_complaints(text).at(0), Contains("points.csv: no points"));
    }
    std::string text = "a\n";
    for (std::size_t k = 0; k <= max_points; ++k) {
        text += std::to_string(k) + "\n";
    }
    CHECK_THAT(sweep_complaints(text).at(0), Contains("points.csv: 10001 points, at most 10000 are allowed"));
}

TEST_CASE("a list that cannot be read is an error of the data") {
    Diagnostics diagnostics;
    const TemporaryFolder folder;
    CHECK_THROWS_AS(list_points(folder / "none.csv", {}, diagnostics), DataError);
    CHECK_THROWS_AS(list_points(folder / "", {}, diagnostics), DataError);
    CHECK_THROWS_AS(read(std::string(100'000, 'x'), diagnostics), DataError);
    CHECK_THROWS_WITH(read(std::string((1U << 24U) + 1, '\n'), diagnostics), Contains("larger than 16 MiB"));
}
