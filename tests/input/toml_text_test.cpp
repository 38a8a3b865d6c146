#include "input/toml_text.hpp"

#include "catch.hpp"

#include "core/text.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

// Files, settings and damage of every kind are tested in deck_file_test.cpp.

namespace {

std::shared_ptr<const Source> source_of(const std::string& text) {
    return std::make_shared<const Source>(Source{"deck.toml", text});
}

Table table_of(const std::string& text) {
    Diagnostics diagnostics;
    const auto table = parse_toml(source_of(text), diagnostics);
    CHECK(diagnostics.entries().empty());
    REQUIRE(table.has_value());
    return *table;
}

/// "line:column+length message (hint)" of the one mistake.
std::string mistake_in(const std::string& text) {
    Diagnostics diagnostics;
    CHECK_FALSE(parse_toml(source_of(text), diagnostics).has_value());
    REQUIRE(diagnostics.entries().size() == 1);
    const Diagnostic& found = diagnostics.entries().front();
    const Location& where = found.location;
    return std::to_string(where.line) + ":" + std::to_string(where.column) + "+" + std::to_string(where.length) + " " +
           found.message + (found.hint.empty() ? "" : " (" + found.hint + ")");
}

template <class T>
T get(const Table& table, const std::string& key) {
    const Entry* entry = find(table, key);
    REQUIRE(entry != nullptr);
    REQUIRE(std::holds_alternative<T>(entry->value.data));
    return std::get<T>(entry->value.data);
}

}  // namespace

TEST_CASE("values of every kind are read, in the order of the text") {
    const Table table = table_of(
        "z = true\ni = -3\nhex = 0xFF\nx = 2.5e-3\ntext = \"a\\tb\"\nraw = 'C:\\n'\nday = 1967-07-05\n"
        "list = [1, 2.0, \"3\"]\ninline = { a = 1, b.c = 2 }\n[table]\nk = 1\n[[stage]]\nn = 1\n[[stage]]\nn = 2\n");
    std::string order;
    for (const Entry& entry : table) {
        order += entry.key + " ";
    }
    CHECK(order == "z i hex x text raw day list inline table stage ");
    CHECK(get<bool>(table, "z"));
    CHECK(get<std::int64_t>(table, "i") == -3);
    CHECK(get<std::int64_t>(table, "hex") == 255);
    CHECK(get<double>(table, "x") == 2.5e-3);
    CHECK(get<std::string>(table, "text") == "a\tb");
    CHECK(get<std::string>(table, "raw") == "C:\\n");
    CHECK(get<Date>(table, "day").text == "1967-07-05");
    const Array list = get<Array>(table, "list");
    REQUIRE(list.size() == 3);
    CHECK(std::holds_alternative<std::int64_t>(list[0].data));
    CHECK(std::holds_alternative<double>(list[1].data));
    CHECK(get<std::int64_t>(get<Table>(get<Table>(table, "inline"), "b"), "c") == 2);
    CHECK(get<Array>(table, "stage").size() == 2);
    CHECK(table_of("").empty());
}

TEST_CASE("every key and value knows its place, columns counted in characters") {
    const std::string text = "# Å\n\"Å\" = 'é'  \n[system]\n  density = 0.8442\n";
    const Table table = table_of(text);
    const Entry& first = table.at(0);
    CHECK(first.key_location.line == 2);
    CHECK(first.key_location.column == 1);
    CHECK(first.value.location.column == 7);
    CHECK(first.value.location.length == 3);
    const Entry& system = table.at(1);
    CHECK(system.value.location.line == 3);
    const Entry density = get<Table>(table, "system").at(0);
    CHECK(density.key_location.line == 4);
    CHECK(density.key_location.column == 3);
    CHECK(density.key_location.length == 7);
    CHECK(density.value.location.column == 13);
    CHECK(density.value.location.length == 6);
    CHECK(density.value.location.source->text == text);
}

TEST_CASE("the first mistake is told in the words of a deck, with its place") {
    CHECK_THAT(mistake_in("a = 1\nb = cut\n"),
               StartsWith("2:5") && Contains("not valid TOML: ") && Contains("text needs quotes"));
    for (const char* word : {"fcc", "force-shifted", "trap", "nist", "ideal"}) {
        CHECK_THAT(mistake_in(std::string("a = ") + word), Contains("this is no value (text needs quotes)"));
    }
    CHECK_THAT(mistake_in("a = 86.5 K\n"), StartsWith("1:10") && Contains("text and units need quotes"));
    CHECK_THAT(mistake_in("a = \"open\n"), Contains("a string must end on its line"));
    CHECK_THAT(mistake_in("a = [1, 2\n"), Contains("the text ends within this array"));
    CHECK(mistake_in("a = 1\na = 2\n") == "2:1+1 key 'a' is given twice");
    CHECK(mistake_in("[t]\n[u]\n[t]\n") == "3:2+1 table 't' is given twice");
    CHECK(mistake_in("a = 9223372036854775808\n") == "1:5+19 '9223372036854775808' does not fit in 64 bits");
    CHECK_THAT(mistake_in("a = 1e400\n"), StartsWith("1:5+5 '1e400' is too large for a number"));
}

TEST_CASE("what is no text is told by its place") {
    CHECK(mistake_in(std::string("a = 1\nb = \0", 11)) ==
          "2:5+1 binary data (a NUL byte) (a deck is plain text in UTF-8)");
    CHECK(mistake_in("a = 1\nÅ\xff = 2") == "2:2+1 invalid UTF-8 (a deck is plain text in UTF-8)");
}

TEST_CASE("32 levels are read and 33 are refused, brackets in strings and comments not counted") {
    const auto brackets = [](std::size_t depth) { return "a = " + std::string(depth, '[') + std::string(depth, ']'); };
    const auto dots = [](int depth) {
        std::string key = "a";
        for (int level = 1; level < depth; ++level) {
            key += ".a";
        }
        return key + " = 1";
    };
    CHECK(table_of(brackets(32)).size() == 1);
    CHECK(mistake_in(brackets(33)) == "1:37+1 nested deeper than 32 levels");
    CHECK(table_of(dots(32)).size() == 1);
    CHECK_THAT(mistake_in(dots(33)), Contains("nested deeper than 32 levels"));
    CHECK_THAT(mistake_in(brackets(100000)), Contains("nested deeper than 32 levels"));
    const std::string many(100, '[');
    CHECK(
        table_of("a = '" + many + "' # " + many + "\nb = \"\\\"" + many + "\"\nc = '''" + many + "\n" + many + "'''\n")
            .size() == 3);
    // a closing quote hides nothing behind it
    CHECK_THAT(mistake_in("a = ['''x''''', " + many + "]"), Contains("nested deeper"));
}
