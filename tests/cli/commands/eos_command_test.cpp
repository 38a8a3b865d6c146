#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/data_list_csv.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "reference/equation_report.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

Said eos(std::vector<std::string> options) {
    options.insert(options.begin(), "eos");
    return said([&] { command(options); });
}

}  // namespace

TEST_CASE("eos prints the equations, coexistence, or a state, by what it is given") {
    const EquationOfState thol = equation_of_state("thol2016");
    CHECK(eos({}).out == equations_document().text);
    CHECK(eos({"--json"}).out == to_json(equations_document().data) + "\n");
    CHECK(eos({"--temperature", "0.9"}).out == coexistence_document(thol, 0.9).text);
    CHECK(eos({"--temperature", "0.9", "--json"}).out == to_json(coexistence_document(thol, 0.9).data) + "\n");
    CHECK(eos({"--temperature", "1.5", "--density", "0.5"}).out == state_document(thol, 1.5, 0.5).text);
    CHECK(eos({"--model", "thol2015", "--temperature", "1.5", "--density", "0.5", "--json"}).out ==
          to_json(state_document(equation_of_state("thol2015"), 1.5, 0.5).data) + "\n");
}

TEST_CASE("eos takes a pressure in place of a density, and alone for coexistence") {
    const EquationOfState thol = equation_of_state("thol2016");
    CHECK(eos({"--temperature", "1.5", "--pressure", "0.5"}).out == pressure_document(thol, 1.5, 0.5).text);
    CHECK(eos({"--pressure", "0.01", "--json"}).out == to_json(saturation_document(thol, 0.01).data) + "\n");
}

TEST_CASE("eos makes a table of a range or a list, as text, JSON or CSV") {
    const EquationOfState thol = equation_of_state("thol2016");
    const EquationPoints points{{0.8, 0.9, 1.0}, {0.1, 0.7}, {}};
    const std::vector<std::string> given{"--temperature", "0.8:1.0:3", "--density", "0.1|0.7"};
    const auto with = [&](const std::string& form) {
        std::vector<std::string> words = given;
        words.push_back(form);
        return eos(words).out;
    };
    CHECK(eos(given).out == points_document(thol, points).text);
    CHECK(with("--json") == to_json(points_document(thol, points).data) + "\n");
    CHECK(with("--csv") == data_list_csv(points_document(thol, points).data["points"]));
    CHECK(eos({"--temperature", "0.9", "--density", "0.7", "--csv"}).out ==
          data_list_csv(points_document(thol, {{0.9}, {0.7}, {}}).data["points"]));
}

TEST_CASE("eos warns of doubtful numbers, and of no others") {
    CHECK(eos({"--temperature", "1.5", "--density", "0.5"}).err.empty());
    CHECK(eos({"--temperature", "0.9"}).err.empty());
    CHECK_THAT(eos({"--temperature", "0.9", "--density", "0.5"}).err, Contains("warning: ") && Contains("coexist"));
    CHECK_THAT(eos({"--temperature", "0.722", "--density", "1.0"}).err,
               StartsWith("warning: at temperature 0.722 the fluid freezes at density 0.8545"));
    CHECK_THAT(eos({"--temperature", "0.6"}).err, Contains("warning: temperature 0.6 is outside"));
}

TEST_CASE("eos refuses what is no temperature, no density, no equation") {
    for (const char* wrong : {"0", "-1", "inf", "nan", "1:2", "1:2:1", "1|1", "1|", "0:1:3"}) {
        INFO(wrong);
        const std::string word = wrong;
        CHECK_THROWS_AS(command({"eos", "--temperature=" + word}), InputError);
        CHECK_THROWS_AS(command({"eos", "--temperature=" + word, "--density", "0.5"}), InputError);
        CHECK_THROWS_AS(command({"eos", "--temperature", "1.0", "--pressure=" + word}), InputError);
    }
    for (const char* wrong : {"-0.1", "inf", "nan"}) {
        CHECK_THROWS_AS(command({"eos", "--temperature", "1.0", std::string("--density=") + wrong}), InputError);
    }
    for (const char* wrong : {"hot", "120 K"}) {
        CHECK_THROWS_AS(command({"eos", "--temperature", wrong}), CLI::ValidationError);
    }
    CHECK_THROWS_AS(command({"eos", "--temperature", "1.0", "--density", "0.5", "--pressure", "0.1"}), InputError);
    CHECK_THROWS_AS(command({"eos", "--temperature", "1.0", "--csv", "--json"}), InputError);
    CHECK_THROWS_AS(command({"eos", "--density", "0.5"}), InputError);
    CHECK_THROWS_AS(command({"eos", "--model", "ideal"}), InputError);
    CHECK_THROWS_AS(command({"eos", "--model", "thol2015"}), InputError);  // all are listed, whatever it says
}
