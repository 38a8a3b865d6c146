#include "input/toml_mistake.hpp"

#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

/// The mistake in a text in which '|' marks where a parser stopped: its message, with what is underlined in brackets.
std::string told(std::string text) {
    const std::size_t stopped = text.find('|');
    text.erase(stopped, 1);
    const TomlMistake found = toml_mistake(text, stopped, "the parser's own words");
    return found.message + (found.length > 0 ? " [" + text.substr(found.offset, found.length) + "]" : "");
}

}  // namespace

TEST_CASE("what is wrong with a text is seen wherever in the word a parser stops") {
    for (const char* text : {"a = |cut\n", "a = c|ut\n", "a = cut|\n", "a = [1, |cut]\n", "x = { a = |cut }\n"}) {
        CAPTURE(text);
        CHECK(told(text) == "not valid TOML: this is no value [c]");
    }
    for (const char* text : {"a = |1e400\n", "a = 1e400|\n", "a = -1e|400\n", "a = [0.5, |1e400]"}) {
        CAPTURE(text);
        CHECK(told(text) == "'1e400' is too large for a number [1e400]");
    }
    for (const char* text : {"a = |99_99999999999999999\n", "a = 99_99999999999999999|"}) {
        CHECK(told(text) == "'99_99999999999999999' does not fit in 64 bits [99_99999999999999999]");
    }
    for (const char* text : {"a = 1\na| = 2\n", "a = 1\na |= 2\n", "a = 1\na = |2\n", "x = { a = 1, b = 2, a = |3 }"}) {
        CAPTURE(text);
        CHECK(told(text) == "key 'a' is given twice [a]");
    }
    CHECK(told("[t]\na = 1\n[u]\n|[t]\n") == "table 't' is given twice [t]");
    CHECK(told("[t]\na = 1\n[u]\n[t]|\n") == "table 't' is given twice [t]");
}

TEST_CASE("what is missing is told with what is there") {
    CHECK(told("a = 1 |2\n") == "not valid TOML: expected the end of the line, saw '2'");
    CHECK(told("a = 0|,8\n") == "not valid TOML: expected the end of the line, saw ','");
    CHECK(told("a 0.8 |\n") == "not valid TOML: expected '=', saw the end of the line");
    CHECK(told("a =|\n") == "not valid TOML: expected value, saw the end of the line");
    CHECK(told("a =|") == "not valid TOML: expected value, saw the end of the text");
    CHECK(told("[a|\nb = 1") == "not valid TOML: expected ']', saw the end of the line");
    CHECK(told("a = { b = 1|\n}") == "not valid TOML: expected '}', saw the end of the line");
    CHECK(told("a = [1, 2\n|") == "not valid TOML: the text ends within this array");
    CHECK(told("|= 1\n") == "not valid TOML: expected a key or a [table], saw '='");
    CHECK(told("[a]|]\n") == "not valid TOML: expected the end of the line, saw ']'");
    CHECK(told("a = \"open|\nb = 1") == "not valid TOML: a string must end on its line");
    CHECK(told("a = \"\"\"open\n|") == "not valid TOML: the text ends within this string");
    CHECK(told("a = \"|\x01\"") == "not valid TOML: control characters are not allowed");
    CHECK(told("a = 1\r|a = 2\r") == "not valid TOML: a carriage return alone ends no line");
    CHECK(told("a = 1.|") == "not valid TOML: a digit must follow the point of a number [1.]");
}

TEST_CASE("the parser's own words count where nothing else is known") {
    CHECK(told("a = \"\\|q\"") == "not valid TOML: the parser's own words");
    CHECK(told("[a]\nb = 1\n|[a.b]") == "not valid TOML: the parser's own words");
    CHECK(told("|") == "not valid TOML: expected a key or a [table], saw the end of the text");
}
