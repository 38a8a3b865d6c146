#include "deck/deck_sense.hpp"

#include <cmath>

#include "deck/deck_fixtures.hpp"
#include "ljmd/model/box.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A deck that is wrong in one way, and the one thing that is to be said about it.
struct Wrong {
    Replacements replacements;
    std::string line;     ///< that is pointed at
    std::string message;  ///< part of it
    std::string hint;     ///< part of it
};

const std::string lattice = "lattice = { type = \"fcc\", cells = 3 }";
const std::string truncation = "truncation = \"force-shifted\"";
const std::string stage = "name = \"production\"";

void check_one(const Wrong& wrong, Severity severity, bool force) {
    const std::string text = changed(small_deck, wrong.replacements);
    INFO(text << "\n-> " << wrong.message);
    const auto found = complaints(text, {}, force);
    REQUIRE(found.size() == 1);
    INFO(format(found[0]));
    CHECK(found[0].severity == severity);
    CHECK(line_shown(found[0]) == wrong.line);
    CHECK_THAT(found[0].message, Contains(wrong.message));
    CHECK_THAT(found[0].hint, Contains(wrong.hint));
}

/// Force changes nothing about what is impossible.
void check_refused(const std::vector<Wrong>& wrongs) {
    for (const Wrong& wrong : wrongs) {
        check_one(wrong, Severity::error, false);
        check_one(wrong, Severity::error, true);
    }
}

}  // namespace

TEST_CASE("a sound deck is not complained of") {
    CHECK(complaints(small_deck).empty());
}

TEST_CASE("a start that cannot be meant is refused at its key") {
    const auto with_lattice = [](const std::string& inner, const std::string& message, const std::string& hint) {
        const std::string line = "lattice = { " + inner + " }";
        return Wrong{{{lattice, line}}, line, message, hint};
    };
    check_refused({
        {{{lattice, lattice + "\nfile = \"start.xyz\""}},
         "file = \"start.xyz\"",
         "one of 'lattice' and 'file'",
         "remove"},
        {{{lattice + "\n", ""}}, "[system]", "one of 'lattice' and 'file'", "lattice = {"},
        with_lattice("type = \"fcc\"", "missing key 'cells'", "'atoms'"),
        with_lattice("type = \"fcc\", cells = 3, atoms = 108", "say the same", "one of them"),
        with_lattice("type = \"fcc\", atoms = 200", "fills no fcc crystal", "108 or 256"),
        with_lattice("type = \"simple-cubic\", atoms = 100", "fills no simple-cubic crystal", "64 or 125"),
        with_lattice("type = \"fcc\", cells = 700", "1372000000 atoms, more than 1073741824", ""),
        with_lattice("type = \"fcc\", cells = 600, layers = 1000", "1440000000 atoms, more than 1073741824", ""),
        with_lattice("type = \"fcc\", atoms = 108, layers = 4", "'layers' in lattice goes with 'cells'", "'cells'"),
        with_lattice("type = \"fcc\", cells = 3, height = 5.0", "'height' in lattice is 5, but the crystal is 5.12993",
                     ""),
        with_lattice("type = \"fcc\", cells = 3, layers = 6, height = 9", "but the crystal is 10.2599 sigma high", ""),
        with_lattice("type = \"random\", atoms = 108, height = 9", "no meaning for a random start", "crystal"),
        with_lattice("type = \"random\"", "missing key 'atoms'", "random start"),
        with_lattice("type = \"random\", cells = 3", "no meaning for a random start", "'atoms'"),
        {{{"density = 0.8\n", ""}}, "[system]", "missing key 'density'", "lattice"},
        {{{"temperature = 1.0\n", ""}}, "[system]", "missing key 'temperature'", "lattice"},
        {{{"seed = 7", "velocities = \"file\""}}, "velocities = \"file\"", "there is no file", "maxwell"},
        {{{lattice, "file = \"start.xyz\""},
          {"temperature = 1.0", "velocities = \"maxwell\""},
          {"thermostat =", "temperature = 1.0\nthermostat ="}},
         "velocities = \"maxwell\"",
         "missing key 'temperature'",
         "Maxwell"},
    });
}

TEST_CASE("starts of every kind are accepted") {
    for (const char* start :
         {"lattice = { type = \"fcc\", atoms = 108 }", "lattice = { type = \"simple-cubic\", cells = 5 }",
          "lattice = { type = \"simple-cubic\", atoms = 125 }", "lattice = { type = \"random\", atoms = 100 }",
          "lattice = { type = \"fcc\", cells = 3, layers = 5 }",
          "lattice = { type = \"fcc\", cells = 3, height = 5.2 }",
          "lattice = { type = \"fcc\", atoms = 108, height = 20 }", "file = \"start.xyz\""}) {
        INFO(start);
        CHECK(complaints(changed(small_deck, {{lattice, start}})).empty());
    }
    CHECK(complaints(changed(small_deck, {{lattice, "file = \"start.xyz\""},
                                          {"density = 0.8\n", ""},
                                          {"temperature = 1.0\n", ""},
                                          {"thermostat =", "temperature = 1.0\nthermostat ="}}))
              .empty());
}

TEST_CASE("a potential whose parts do not go together is refused at its key") {
    check_refused({
        {{{truncation, "truncation = \"cut\""}}, "[potential]", "missing key 'tail'", "true or false"},
        {{{truncation, "truncation = \"switched\"\nswitch_start = 1.5"}}, "[potential]", "missing key 'tail'", ""},
        {{{truncation, truncation + "\ntail = true"}},
         "tail = true",
         "no meaning for truncation = \"force-shifted\"",
         ""},
        {{{truncation, "truncation = \"shifted\"\ntail = true"}}, "tail = true", "no meaning", ""},
        {{{truncation, "truncation = \"switched\"\ntail = false\nswitch_start = 2.0"}},
         "switch_start = 2.0",
         "not below the cutoff 2",
         ""},
    });
    for (const char* good :
         {"truncation = \"cut\"\ntail = false", "truncation = \"cut\"\ntail = true",
          "truncation = \"shifted\"\ntail = false", "truncation = \"switched\"\nswitch_start = 1.9\ntail = true"}) {
        INFO(good);
        CHECK(complaints(changed(small_deck, {{truncation, good}})).empty());
    }
}

TEST_CASE("what only a list has is refused at its key with another way to the neighbours") {
    check_refused({
        {{{"sample = true", "sample = true\n[neighbors]\nmethod = \"cells\"\nevery = 20"}},
         "every = 20",
         "no meaning for method = \"cells\"",
         "only a list"},
        {{{"sample = true",
           "sample = true\n[neighbors]\nmethod = \"all-pairs\"\n[performance]\nprecision = \"mixed\""}},
         "precision = \"mixed\"",
         "which method = \"all-pairs\" does not have",
         "verlet-list has it"},
    });
}

TEST_CASE("outputs that cannot be meant are refused at their key") {
    check_refused({
        {{{"sample = true", "sample = true\n[output]\ndirectory = \"\""}}, "directory = \"\"", "empty", ""},
        {{{"sample = true", "sample = true\n[output.trajectory]\nevery = 1\nunits = \"si\""}},
         "units = \"si\"",
         "needs an [argon] table",
         ""},
    });
}

TEST_CASE("what is merely unlikely is refused, and only warned of when forced") {
    const std::vector<Wrong> unlikely{
        // So hot that it is not known where the fluid freezes.
        {{{"density = 0.8", "density = 1.51"},
          {"cutoff = 2.0", "cutoff = 1.9"},
          {"temperature = 1.0", "temperature = 6.0"}},
         "density = 1.51",
         "above 1.5",
         ""},
        {{{"temperature = 1.0", "temperature = 86.5"}}, "temperature = 86.5", "'temperature' in [system]", ""},
        {{{"sample = true", "sample = true\nthermostat = { type = \"langevin\" }\ntemperature = 86.5"}},
         "temperature = 86.5",
         "'temperature' in [[stage]]",
         ""},
        {{{"time_step = 0.004", "time_step = 0.02"}}, "time_step = 0.02", "'time_step' in [[stage]] is 0.02", ""},
        {{{"cutoff = 2.0", "cutoff = 0.5"}}, "cutoff = 0.5", "the core of the potential is cut", ""},
    };
    for (Wrong wrong : unlikely) {
        check_one(wrong, Severity::warning, true);
        wrong.hint = "--force";
        check_one(wrong, Severity::error, false);
    }
    CHECK(complaints(changed(small_deck, {{"density = 0.8", "density = 1.5"},
                                          {"cutoff = 2.0", "cutoff = 2.08"},
                                          {"temperature = 1.0", "temperature = 6.0"}}))
              .empty());
    CHECK(complaints(changed(small_deck, {{"temperature = 1.0", "temperature = 50"}})).empty());
    CHECK(complaints(changed(small_deck, {{"time_step = 0.004", "time_step = 0.0199"}})).empty());
    CHECK(complaints(changed(small_deck, {{"cutoff = 2.0", "cutoff = 1.0"}})).empty());
    CHECK(complaints(changed(small_deck, {{"[[stage]]", "[neighbors]\nskin = 0.3\nevery = 100\n[[stage]]"}})).empty());
}

TEST_CASE("what has no effect, or one that few want, is warned of") {
    const std::vector<Wrong> doubtful{
        {{{"sample = true", "sample = true\ntemperature = 2.0"}},
         "temperature = 2.0",
         "no effect without a thermostat",
         ""},
        {{{"thermostat =", "sample = true\nthermostat ="}}, "sample = true", "samples no ensemble", ""},
        {{{"cells = 3", "cells = 10"}, {"cutoff = 2.0", "cutoff = 6.5"}}, "cutoff = 6.5", "more than 6", "angstrom"},
        {{{"[[stage]]", "[neighbors]\nskin = 0.3\nevery = 500\n[[stage]]"}},
         "every = 500",
         "'every' in [neighbors] is 500: atoms fly 3.5 sigma",
         "leave it out"},
    };
    for (const Wrong& wrong : doubtful) {
        check_one(wrong, Severity::warning, false);
    }
}

TEST_CASE("the cutoff may be half the box and no more, the largest value is told and accepted") {
    for (const char* start : {"lattice = { type = \"fcc\", cells = 3 }", "lattice = { type = \"fcc\", atoms = 108 }",
                              "lattice = { type = \"random\", atoms = 108 }"}) {
        const auto found = complaints(changed(small_deck, {{lattice, start}, {"cutoff = 2.0", "cutoff = 2.57"}}));
        REQUIRE(found.size() == 1);
        CHECK(line_shown(found[0]) == "cutoff = 2.57");
        const std::string lead = "largest allowed: ";
        REQUIRE(found[0].hint.starts_with(lead));
        const std::string largest = found[0].hint.substr(lead.size());
        CHECK(std::stod(largest) == Approx(0.5 * std::cbrt(108 / 0.8)).epsilon(1e-14));
        CHECK(complaints(changed(small_deck, {{lattice, start}, {"cutoff = 2.0", "cutoff = " + largest}})).empty());
        const std::string above = "cutoff = " + std::to_string(std::stod(largest) + 2e-6);
        CHECK(complaints(changed(small_deck, {{lattice, start}, {"cutoff = 2.0", above}})).size() == 1);
    }
}

TEST_CASE("angstrom as sigma are recognised in the cutoff") {
    const auto found = complaints(changed(small_deck, {{"cutoff = 2.0", "cutoff = 8.5"}}));
    REQUIRE(found.size() == 2);  // larger than the box, and larger than usual
    CHECK(found[1].severity == Severity::error);
    CHECK_THAT(found[1].hint, Contains("largest allowed") && Contains("angstrom"));
}

TEST_CASE("an analysis that does not fit the box is refused at its key") {
    const std::string rdf = "\n[analysis.rdf]\nradius = 3.0\nevery = 5\n";
    const auto found = complaints(small_deck + rdf);
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == Severity::error);
    CHECK(line_shown(found[0]) == "radius = 3.0");
    CHECK(complaints(small_deck + changed(rdf, {{"3.0", "2.5"}})).empty());
}

TEST_CASE("a box that is known late is checked in the same way") {
    const DeckFolder folder(changed(small_deck, {{lattice, "file = \"start.xyz\""}}));
    const Deck deck = folder.load();
    Diagnostics good;
    check_box(deck.fluid(), 100, Box(Vec3(4.0, 5.0, 6.0)), good);
    CHECK(good.entries().empty());
    Diagnostics bad;
    check_box(deck.fluid(), 100, Box(Vec3(6.0, 5.0, 3.75)), bad);
    REQUIRE(bad.entries().size() == 1);
    CHECK(line_shown(bad.entries()[0]) == "cutoff = 2.0");
    CHECK_THAT(bad.entries()[0].hint, Contains("1.875"));
}

TEST_CASE("a value that is wrong in itself is reported once") {
    for (const Replacements& wrong :
         {Replacements{{"density = 0.8", "density = \"dense\""}}, Replacements{{"density = 0.8", "densty = 0.8"}},
          Replacements{{"cutoff = 2.0", "cutoff = -2.0"}}, Replacements{{"cells = 3", "cells = 0"}},
          Replacements{{"type = \"fcc\"", "type = \"bcc\""}}, Replacements{{truncation, "truncation = \"none\""}},
          Replacements{{truncation, "truncation = \"cut\"\ntail = 1"}}, Replacements{{stage, "nam = \"production\""}},
          Replacements{{"steps = 40", "steps = 1e3"}}, Replacements{{lattice, "lattice = \"fcc\""}}}) {
        const auto found = complaints(changed(small_deck, wrong));
        std::string all;
        for (const Diagnostic& entry : found) {
            all += format(entry) + "\n";
        }
        INFO(all);
        CHECK(found.size() == 1);
    }
}
