#include "options/words_elsewhere.hpp"

#include "catch.hpp"

using namespace ljmd;
using Catch::Contains;

TEST_CASE("words of other programs and texts are answered by what stands in a deck, however they are written") {
    for (const char* word : {"csvr", "CSVR", "Bussi", "v-rescale", "V_Rescale", "temp/csvr"}) {
        CAPTURE(word);
        CHECK_THAT(word_elsewhere(word), Contains("'stochastic-rescaling'"));
    }
    CHECK_THAT(word_elsewhere("NVE"), Contains("without thermostat"));
    CHECK_THAT(word_elsewhere("nvt"), Contains("thermostat = {"));
    CHECK_THAT(word_elsewhere("WCA"), Contains("cutoff = 1.1224"));
    CHECK_THAT(word_elsewhere("bcc"), Contains("comes from a file"));
    CHECK_THAT(word_elsewhere("dimensions"), Contains("three dimensions"));
    CHECK_THAT(word_elsewhere("intermediate_scattering"), Contains("'scattering'"));
    CHECK_THAT(word_elsewhere("Tdamp"), Contains("'time'"));
    CHECK_THAT(word_elsewhere("epsilon"), Contains("the unit"));
    CHECK_THAT(word_elsewhere("heat_capacity"), Contains("without being asked"));
    CHECK_THAT(word_elsewhere("density_profile"), Contains("'film'"));
    CHECK_THAT(word_elsewhere("g(r)"), Contains("'rdf'"));
    CHECK_THAT(word_elsewhere("steinhardt"), Contains("not in ljmd"));
}

TEST_CASE("other words have no such answer") {
    for (const char* word : {"", " ", "-", "densty", "cut", "temperature", "nve nvt"}) {
        CAPTURE(word);
        CHECK(word_elsewhere(word).empty());
    }
}
