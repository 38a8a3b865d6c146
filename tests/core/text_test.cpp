#include "core/text.hpp"

#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("utf8_length tells characters from stray bytes") {
    CHECK(utf8_length("a") == 1);
    CHECK(utf8_length("\xC3\x85x") == 2);
    CHECK(utf8_length("\xE2\x84\xAB") == 3);
    CHECK(utf8_length("\xED\x9F\xBF") == 3);
    CHECK(utf8_length("\xF0\x9F\x98\x80") == 4);
    CHECK(utf8_length("\xF4\x8F\xBF\xBF") == 4);
    for (const char* bad :
         {"", "\x80", "\xC3", "\xC3x", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xE2\x84", "\xED\xA0\x80",
          "\xF0\x80\x80\x80", "\xF0\x9F\x98", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
        CHECK(utf8_length(bad) == 0);
    }
}

TEST_CASE("find_invalid_utf8 points at the byte") {
    CHECK(find_invalid_utf8("a \xC3\x85 \xE2\x84\xAB") == std::string_view::npos);
    CHECK(find_invalid_utf8("a \xC3\x85 \xE2\x84") == 5);
    CHECK(find_invalid_utf8("") == std::string_view::npos);
}

TEST_CASE("printable text moves no cursor and ends in time") {
    CHECK(printable("a\tb\x1B[31m\x7F\r\n", 80) == "a b?[31m???");
    CHECK(printable("\xC2\x9B"
                    "2J \xC3\x85 \xFF",
                    80) == "?2J \xC3\x85 ?");
    CHECK(printable("\xC3\x85\xC3\x85\xC3\x85", 3) == "\xC3\x85\xC3\x85\xC3\x85");
    CHECK(printable("\xC3\x85\xC3\x85\xC3\x85", 2) == "\xC3\x85\xC3\x85...");
    CHECK(printable(std::string(100000, 'x'), 4) == "xxxx...");
}

TEST_CASE("quoted text is short and in quotes") {
    CHECK(in_quotes("densty") == "'densty'");
    CHECK(in_quotes(std::string(61, 'x')) == "'" + std::string(60, 'x') + "...'");
}

TEST_CASE("a mean has as many decimals as its error, which has two digits") {
    CHECK(with_error(-6.08712, 0.00123) == "-6.0871 +- 0.0012");
    CHECK(with_error(0.722, 0.021) == "0.722 +- 0.021");
    CHECK(with_error(1234.567, 123.0) == "1235 +- 123");
    CHECK(with_error(1.5, 0.0) == "1.5");
    CHECK(with_error(-2.5413951, 1.1e-9) == "-2.5413951000 +- 0.0000000011");
    CHECK(with_error(-2.5413951, 1.1e-15) == "-2.5413951 +- 1.1e-15");
    CHECK(with_error(3.27e-16, 1.1e-17) == "3.27e-16 +- 1.1e-17");
    CHECK(with_error(-0.0, 1.1e-17) == "0 +- 1.1e-17");
    CHECK(with_error(-0.0, 0.0) == "0");
    CHECK(with_error(-0.001, 0.15) == "0.00 +- 0.15");
    CHECK(with_error(1.23456789, std::numeric_limits<double>::quiet_NaN()) == "1.23457");
}

TEST_CASE("blanks around a text are left out, those in it are not") {
    CHECK(trimmed(" \t86.5 K ") == "86.5 K");
    CHECK(trimmed("a") == "a");
    CHECK(trimmed(" \t ").empty());
    CHECK(trimmed("").empty());
}

TEST_CASE("a number is one when it is all of a text, and finite") {
    CHECK(to_number("0.85") == 0.85);
    CHECK(to_number("-1e-3") == -0.001);
    for (const char* text : {"", " 1", "1 ", "+1", "1,5", "0x10", "nan", "inf", "1e999", "1e", "86.5 K", "-"}) {
        INFO(text);
        CHECK_FALSE(to_number(text).has_value());
    }
}

TEST_CASE("line_of finds a line without its end") {
    const std::string text = "one\r\n\ntwo\nlast";
    CHECK(line_of(text, 1) == "one");
    CHECK(line_of(text, 2).empty());
    CHECK(line_of(text, 3) == "two");
    CHECK(line_of(text, 4) == "last");
    CHECK(line_of(text, 5).empty());
}

TEST_CASE("a paragraph is broken at spaces, and long words stand alone") {
    CHECK(wrapped("one two three", 80, 4) == "one two three");
    CHECK(wrapped("one two three", 8, 0) == "one two\nthree");
    CHECK(wrapped("one two three", 7, 2) == "one two\n  three");
    CHECK(wrapped("  [1] one two", 9, 6) == "  [1] one\n      two");
    CHECK(wrapped("a-word-that-is-too-long for it", 8, 2) == "a-word-that-is-too-long\n  for it");
    CHECK(wrapped("\xC3\xA9\xC3\xA9 \xC3\xA9\xC3\xA9", 5, 0) == "\xC3\xA9\xC3\xA9 \xC3\xA9\xC3\xA9");
    CHECK(wrapped("", 8, 2).empty());
}

TEST_CASE("a literal is read back as it was, by Python and C++") {
    CHECK(string_literal("runs/mine") == "\"runs/mine\"");
    CHECK(string_literal("a \"b\" \\ c") == R"("a \"b\" \\ c")");
    CHECK(string_literal("f\u00fcr \xff") == "\"f\u00fcr \xff\"");
    CHECK(string_literal("1\n2\x1b"
                         "3\x7f") == R"("1\0122\0333\177")");
}
