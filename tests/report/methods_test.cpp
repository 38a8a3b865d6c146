#include "report/methods.hpp"

#include "deck/sample_decks.hpp"
#include "io/files/input_file.hpp"
#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("the methods of a run name potential, stages, errors and program") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_whole(deck);
    const std::string words = methods_paragraph(run_facts(deck.directory));
    CHECK_THAT(words, Contains("108 atoms") && Contains("lennard-jones, force-shifted at 2 sigma"));
    for (const Stage& stage : deck.stages()) {
        CHECK_THAT(words, Contains("Stage '" + stage.name + "'"));
    }
    CHECK_THAT(words, Contains("velocity-verlet") && Contains("10.1063/1.457480") && Contains("Computed with ljmd"));
}

TEST_CASE("the methods of few bodies name the force") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load();
    run_whole(deck);
    CHECK_THAT(methods_paragraph(run_facts(deck.directory)), Contains("2 bodies under the force newtonian-gravity"));
}

TEST_CASE("the program is cited as CITATION.cff says") {
    const std::string citation = read_input(std::string(LJMD_INPUTS) + "/../CITATION.cff");
    const std::string bibtex = bibtex_of("9.9.9");
    for (const char* fact :
         {"ljmd: Lennard-Jones molecular dynamics", "GPL-3.0-or-later", "10.1103/PhysRev.159.98", "Physical Review"}) {
        CHECK_THAT(citation, Contains(fact));
        CHECK_THAT(bibtex, Contains(fact));
    }
    CHECK_THAT(bibtex, Contains("version = {9.9.9}"));
}
