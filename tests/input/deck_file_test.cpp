#include "input/deck_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "io/parsed_deck.hpp"
#include "ljmd/detail/options/section.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

namespace fs = std::filesystem;

/// A file in a folder that the test has for itself.
fs::path written(const TemporaryFolder& folder, const std::string& base, const std::string& content) {
    std::ofstream(folder / base, std::ios::binary) << content;
    return folder / base;
}

const std::string good_deck = R"(title = "Liquid argon"   # Å
units = "reduced"

[argon]
sigma = "3.405 Å"
epsilon = '119.8 K'

[system]
lattice = { type = "fcc", cells = 6 }
density = 0.8442
temperature = "86.5 K"

[[stage]]
name = "equilibrate"
steps = 5_000
start = [0.0, -1.5e-3,
         0x10]

[[stage]]
name = "production"
steps = 20000
sample = true
)";

Schema deck_schema() {
    const Schema argon("[argon]", {Key::quantity("sigma", Dimension::length).above(0.0),
                                   Key::quantity("epsilon", Dimension::energy).above(0.0)});
    const Schema lattice("lattice", {Key::choice("type", {"fcc", "sc"}), Key::integer("cells").at_least(1)});
    const Schema system("[system]", {Key::table("lattice", lattice), Key::number("density").above(0.0).at_most(1.5),
                                     Key::number("temperature").at_least(0.0).dimension(Dimension::temperature)});
    const Schema stage("[[stage]]",
                       {Key::text("name"), Key::integer("steps").at_least(0), Key::flag("sample").defaults_to(false)});
    return Schema("the deck", {Key::text("title").optional(), Key::text("units"), Key::table("argon", argon).optional(),
                               Key::table("system", system), Key::tables("stage", stage)});
}

/// The one error that a text gives, without "error: ".
std::string mistake(const std::string& text) {
    Diagnostics diagnostics;
    const DeckFile deck = parse_deck("d", text, diagnostics);
    REQUIRE(diagnostics.entries().size() == 1);
    CHECK(deck.table.empty());
    return format(diagnostics.entries().front()).substr(7);
}

/// The same for a file.
std::string read_mistake(const fs::path& path) {
    Diagnostics diagnostics;
    const DeckFile deck = read_deck(path, diagnostics);
    REQUIRE(diagnostics.entries().size() == 1);
    CHECK(deck.source->name == path.string());
    return diagnostics.entries().front().message;
}

}  // namespace

TEST_CASE("a deck is read in the order of its text, every part with its place") {
    Diagnostics diagnostics;
    const DeckFile deck = parse_deck("argon.toml", good_deck, diagnostics);
    CHECK(formatted(diagnostics).empty());
    CHECK(deck.source->name == "argon.toml");
    CHECK(deck.source->text == good_deck);
    std::string keys;
    for (const Entry& entry : deck.table) keys += entry.key + " ";
    CHECK(keys == "title units argon system stage ");

    const Table& system = inner(deck.table, "system");
    CHECK(at(deck.table, "system").location.line == 8);
    CHECK(at(deck.table, "system").location.length == 8);
    const Entry& density = *find(system, "density");
    CHECK(std::get<double>(density.value.data) == 0.8442);
    CHECK(density.key_location.line == 10);
    CHECK(density.key_location.column == 1);
    CHECK(density.key_location.length == 7);
    CHECK(density.value.location.column == 11);
    CHECK(density.value.location.length == 6);
    CHECK(at(inner(deck.table, "argon"), "sigma").location.length == 9);  // characters, not bytes
    CHECK(std::get<std::int64_t>(at(inner(system, "lattice"), "cells").data) == 6);
    CHECK(at(inner(system, "lattice"), "cells").location.column == 35);

    const auto& stages = std::get<Array>(at(deck.table, "stage").data);
    REQUIRE(stages.size() == 2);
    CHECK(stages[1].location.line == 19);
    const Table& first = std::get<Table>(stages[0].data);
    CHECK(std::get<std::int64_t>(at(first, "steps").data) == 5000);
    const auto& start = std::get<Array>(at(first, "start").data);
    CHECK(std::get<double>(start[1].data) == -1.5e-3);
    CHECK(std::get<std::int64_t>(start[2].data) == 16);
    CHECK(start[2].location.line == 17);
    CHECK(std::get<bool>(at(std::get<Table>(stages[1].data), "sample").data));
}

TEST_CASE("dates of every kind are kept as text, dotted and quoted keys work") {
    const Table table = parsed("a = 1967-07-05\nb = 07:32:00\nc = 1967-07-05T07:32:00Z\nd.e.\"f g\" = 1\n");
    CHECK(std::get<Date>(at(table, "a").data).text == "1967-07-05");
    CHECK(std::get<Date>(at(table, "b").data).text == "07:32:00");
    CHECK(std::get<Date>(at(table, "c").data).text == "1967-07-05T07:32:00Z");
    CHECK(std::get<std::int64_t>(at(inner(inner(table, "d"), "e"), "f g").data) == 1);
}

TEST_CASE("a byte order mark and CRLF change nothing") {
    const TemporaryFolder folder;
    Diagnostics diagnostics;
    const DeckFile deck = read_deck(written(folder, "bom.toml",
                                            "\xEF\xBB\xBF"
                                            "a = 1\r\n[b]\r\nc = 'x'\r\n"),
                                    diagnostics);
    CHECK(formatted(diagnostics).empty());
    CHECK(find(deck.table, "a")->key_location.column == 1);
    CHECK(deck.source->text.starts_with("a = 1\r\n"));
    CHECK(std::get<std::string>(at(inner(deck.table, "b"), "c").data) == "x");
}

TEST_CASE("what is no deck file is refused by name") {
    const TemporaryFolder folder;
    CHECK(read_mistake(folder / "none.toml") == "no such file");
    CHECK(read_mistake(folder / std::string(1000, 'x')) == "cannot be read: File name too long");
    CHECK(read_mistake(folder / "") == "is a directory, not a regular file");
    CHECK(read_mistake("/dev/zero") == "is a device or a socket, not a regular file");
    const fs::path fifo = folder / "fifo";
    REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
    CHECK(read_mistake(fifo) == "is a pipe, not a regular file");
    CHECK(read_mistake(written(folder, "empty.toml", "")) == "the deck is empty");
    CHECK(read_mistake(written(folder, "comment.toml", "# nothing\n\n")) == "the deck is empty");
    CHECK(read_mistake(written(folder, "binary.toml", std::string("a = 1\n\0\0", 8))) == "binary data (a NUL byte)");
    const std::size_t mebibyte = std::size_t{1} << 20;
    CHECK(read_mistake(written(folder, "large.toml", std::string(mebibyte + 1, '#'))) ==
          "larger than 1 MiB, which no deck is");
    const fs::path sparse = written(folder, "huge.toml", "a = 1\n");
    fs::resize_file(sparse, std::uintmax_t{1} << 30);
    CHECK(read_mistake(sparse) == "larger than 1 MiB, which no deck is");
    const fs::path locked = written(folder, "locked.toml", "a = 1\n");
    fs::permissions(locked, fs::perms::none);
    if (geteuid() != 0) CHECK(read_mistake(locked) == "cannot be read: Permission denied");

    Diagnostics diagnostics;
    static_cast<void>(
        read_deck(written(folder, "full.toml", "a = 1\n#" + std::string(mebibyte - 7, 'x')), diagnostics));
    CHECK(formatted(diagnostics).empty());
}

TEST_CASE("one mistake of the TOML gives one error with its place") {
    CHECK(mistake("[system]\ndensity 0.8\n") ==
          "d:2:9: not valid TOML: expected '=', saw '0'\n  2 | density 0.8\n    |         ^");
    CHECK(mistake("a =\nb = 1") ==
          "d:1:4: not valid TOML: expected value, saw the end of the line\n  1 | a =\n    |    ^");
    CHECK(mistake("a = cut") ==
          "d:1:5: not valid TOML: this is no value\n  1 | a = cut\n    |     ^ text needs quotes");
    CHECK(mistake("T = 86.5 K # \xC3\x85") ==
          "d:1:10: not valid TOML: expected the end of the line, saw 'K'\n  1 | T = 86.5 K # \xC3\x85\n"
          "    |          ^ text and units need quotes");
    CHECK(mistake("[a]]").find("d:1:4: not valid TOML: expected the end of the line, saw ']'\n") == 0);
    CHECK(mistake("[a").find("d:1:3: not valid TOML: expected ']', saw the end of the text") == 0);
    CHECK(mistake("= 1").find("d:1:1: not valid TOML: expected a key or a [table], saw '='") == 0);
    CHECK(mistake("a = \"x\nb = 1").find("d:1:7: not valid TOML: a string must end on its line") == 0);
    CHECK(mistake("a = \"\x01\"").find("d:1:6: not valid TOML: control characters are not allowed") == 0);
    CHECK(mistake("a = 1.").find("a digit must follow the point of a number") != std::string::npos);
    CHECK(mistake("a = \"\\q\"").find("unknown escape sequence '\\q'") != std::string::npos);
}

TEST_CASE("a key given twice and a number that does not fit are named") {
    CHECK(mistake("steps = 1\nx = { \xC3\x85 = 2 }").find("d:2:7: not valid TOML") == 0);
    CHECK(mistake("steps = 1\n steps = 2\n") == "d:2:2: key 'steps' is given twice\n  2 |  steps = 2\n    |  ^^^^^");
    CHECK(mistake("x = { \"\xC3\x85\" = 1, b = 2, b = 3 }").find("d:1:23: key 'b' is given twice") == 0);
    CHECK(mistake("[a]\nb = 1\n[a]\n") == "d:3:2: table 'a' is given twice\n  3 | [a]\n    |  ^");
    CHECK(mistake("[a]\nb = 1\n[a.b]").find("d:3:1: not valid TOML: ") == 0);
    CHECK(mistake("n = 9223372036854775808\n") ==
          "d:1:5: '9223372036854775808' does not fit in 64 bits\n  1 | n = 9223372036854775808\n"
          "    |     ^^^^^^^^^^^^^^^^^^^");
    CHECK(mistake("x = -1e400").find("d:1:6: '1e400' is too large for a number") == 0);
    CHECK(std::get<std::int64_t>(at(parsed("n = -9223372036854775808"), "n").data) ==
          std::numeric_limits<std::int64_t>::min());
}

TEST_CASE("bytes that are no UTF-8 are found exactly") {
    CHECK(mistake("# \xC3\x85\n\xC3\x85 = \xFF") ==
          "d:2:5: invalid UTF-8\n  2 | \xC3\x85 = ?\n    |     ^ a deck is plain text in UTF-8");
    CHECK(mistake("a = \"\xC3").find("d:1:6: invalid UTF-8") == 0);
    CHECK(mistake(std::string("a = 1\0", 6)).find("d:1:6: binary data (a NUL byte)") == 0);
}

TEST_CASE("depth is bounded, whatever hides it") {
    const std::string many(10000, '[');
    const std::string braces = [] {
        std::string text = "a = ";
        for (int i = 0; i < 10000; ++i) text += "{ a = ";
        return text;
    }();
    std::string dotted = "a";
    for (int i = 0; i < 100000; ++i) dotted += ".a";
    for (const std::string& text :
         {many, "a = " + many, braces, dotted + " = 1", "[" + dotted + "]", "a = [ \"\"\"x\"\"\"\", " + many,
          "a = '[' # '\nb = " + many, "a = '''\n''''', " + many, "a = \"\\\"\"\nb = " + many}) {
        CHECK(mistake(text).find("nested deeper than 32 levels") != std::string::npos);
    }
    const std::string dots(1000, '.');
    CHECK(
        parsed("a = '" + many + dots + "' # " + many + dots + "\nb = \"\"\"\n\"" + many + dots + "\\\"\"\"\"").size() ==
        2);
    CHECK(parsed("a = " + std::string(32, '[') + std::string(32, ']')).size() == 1);
    CHECK(mistake("a = " + std::string(33, '[') + std::string(33, ']')).find("d:1:37: nested") == 0);
}

TEST_CASE("all mistakes of a deck, as a user reads them") {
    std::string text = good_deck;
    text.replace(text.find("density"), 7, "densty");
    text.replace(text.find("cells = 6"), 9, "cells = 0");
    text.replace(text.find("5_000"), 5, "5.5");
    Diagnostics diagnostics;
    const DeckFile deck = parse_deck("argon.toml", text, diagnostics);
    const SubstanceUnits argon(3.405e-10, 1.65e-21, 6.63e-26);
    static_cast<void>(validate(deck.table, {deck.source}, deck_schema(), argon, diagnostics));
    CHECK_THROWS_WITH(diagnostics.throw_if_errors(),
                      "error: argon.toml:9:35: 'cells' in lattice is 0, allowed: >= 1\n"
                      "  9 | lattice = { type = \"fcc\", cells = 0 }\n"
                      "    |                                   ^\n"
                      "error: argon.toml:10:1: unknown key 'densty' in [system]\n"
                      "  10 | densty = 0.8442\n"
                      "     | ^^^^^^ did you mean 'density'?\n"
                      "error: argon.toml:15:9: 'steps' in [[stage]] must be an integer, found a float\n"
                      "  15 | steps = 5.5\n"
                      "     |         ^^^ allowed: >= 0\n"
                      "error: argon.toml:16:1: unknown key 'start' in [[stage]]\n"
                      "  16 | start = [0.0, -1.5e-3,\n"
                      "     | ^^^^^ known keys: name, steps, sample\n"
                      "4 errors. Nothing was run.");
}

TEST_CASE("a mistake in an array of numbers is shown at the component") {
    Diagnostics diagnostics;
    const DeckFile deck = parse_deck("two.toml", "[[body]]\nposition = [ 1.0, \"0\",\n  inf ]\n", diagnostics);
    const Schema body("[[body]]", {Key::vector("position")});
    static_cast<void>(validate(deck.table, {deck.source}, Schema("the deck", {Key::tables("body", body)}), std::nullopt,
                               diagnostics));
    CHECK(formatted(diagnostics) ==
          std::vector<std::string>{
              "error: two.toml:2:19: component 2 of 'position' in [[body]] must be a number, found a string\n"
              "  2 | position = [ 1.0, \"0\",\n"
              "    |                   ^^^ remove the quotes",
              "error: two.toml:3:3: component 3 of 'position' in [[body]] must be finite, found inf\n"
              "  3 |   inf ]\n"
              "    |   ^^^"});
}

TEST_CASE("no damage to a deck crashes: it is read, or there is a message") {
    const auto survives = [](const std::string& text) {
        Diagnostics diagnostics;
        const DeckFile deck = parse_deck("damaged.toml", text, diagnostics);
        if (!diagnostics.has_errors()) {
            const Section section = validate(deck.table, {deck.source}, deck_schema(), std::nullopt, diagnostics);
            // Usable even after mistakes.
            const double density = std::get<double>(section.section("system").plain("density"));
            if (!(density > 0.0 && density <= 1.5)) return false;
        }
        for (const Diagnostic& diagnostic : diagnostics.entries()) {
            const std::string shown = format(diagnostic);
            if (diagnostic.message.empty() || std::count(shown.begin(), shown.end(), '\n') > 2) return false;
        }
        return diagnostics.has_errors() || !deck.table.empty();
    };
    for (std::size_t length = 0; length <= good_deck.size(); ++length) REQUIRE(survives(good_deck.substr(0, length)));
    for (std::size_t i = 0; i < good_deck.size(); ++i) {
        for (const char byte :
             {'\0', '\n', '\r', '"', '\'', '[', ']', '{', '.', '=', '-', '_', 'e', '\\', '\x1B', '\xFF'}) {
            std::string damaged = good_deck;
            damaged[i] = byte;
            REQUIRE(survives(damaged));
        }
        std::string flipped = good_deck;
        flipped[i] = static_cast<char>(flipped[i] ^ 0x10);
        REQUIRE(survives(flipped));
        REQUIRE(survives(good_deck.substr(0, i) + good_deck.substr(i + 1)));
    }
}
