#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Programs to compare with are run by tests/cli/compares.py and judges.py.

TEST_CASE("compare holds few bodies against GSL, and writes what it is told") {
    const DeckFolder folder(stars_deck);
    const std::string deck = folder.deck_path().string();
    const std::string out = (folder / "out").string();
    const Data found = parse_json(said([&] {
                                      command({"compare", deck, "--with", "gsl", "--out", out, "--json", "--quiet"});
                                  }).out);
    CHECK(found.at("with") == "gsl");
    CHECK(std::filesystem::exists(folder / "out" / "compare-gsl.json"));
    CHECK_THROWS_AS(command({"compare", deck, "--with", "gsl", "--out", out, "--quiet"}), InputError);
}

TEST_CASE("compare refuses programs that it does not know, and options without an effect") {
    const DeckFolder folder;
    const std::string deck = folder.deck_path().string();
    CHECK_THROWS_WITH(command({"compare", deck, "--with", "gromacs"}),
                      Contains("unknown program 'gromacs'") && Contains("allowed: gsl, lammps, openmm"));
    CHECK_THROWS_WITH(command({"compare", deck, "--with", "lammps", "--platform", "CPU"}), Contains("OpenMM's"));
    CHECK_THROWS_WITH(command({"compare", deck, "--with", "gsl", "--steps", "5"}), Contains("are for a fluid"));
    CHECK_THROWS_AS(command({"compare", deck}), CLI::ParseError);
    const DeckFolder bodies(stars_deck);
    CHECK_THROWS_WITH(command({"compare", bodies.deck_path().string(), "--with", "lammps"}),
                      Contains("'--with gsl' compares it"));
}
