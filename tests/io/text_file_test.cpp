#include "ljmd/io/text_file.hpp"

#include <catch2/catch.hpp>

#include "io/written_file.hpp"

using namespace ljmd;
using ljmd::test::data_error;
using ljmd::test::WrittenFile;

namespace {

std::vector<std::string> lines_of(const std::string& bytes) {
    const WrittenFile written(bytes);
    TextFile file(written.path());
    std::vector<std::string> lines;
    while (file.next_line()) lines.emplace_back(file.line());
    REQUIRE(file.line_number() == static_cast<Index>(lines.size()));
    return lines;
}

}  // namespace

TEST_CASE("lines end in LF, CRLF or the end of the file, and a byte order mark is dropped") {
    using Lines = std::vector<std::string>;
    CHECK(lines_of("").empty());
    CHECK(lines_of("a\nb\n") == Lines{"a", "b"});
    CHECK(lines_of("a\r\nb\r\n") == Lines{"a", "b"});
    CHECK(lines_of("a\nb") == Lines{"a", "b"});
    CHECK(lines_of("a\r\n\r\nb") == Lines{"a", "", "b"});
    CHECK(lines_of("\n\n") == Lines{"", ""});
    CHECK(lines_of("\xEF\xBB\xBF"
                   "a\n\xEF\xBB\xBF") == Lines{"a", "\xEF\xBB\xBF"});
    CHECK(lines_of(std::string("a\0b\n", 4)) == Lines{std::string("a\0b", 3)});
}

TEST_CASE("a line of the greatest length is read and a longer one is refused with its number") {
    const std::string longest(TextFile::longest_line, 'x');
    CHECK(lines_of("a\n" + longest).back() == longest);
    const WrittenFile written("a\n" + longest + "y\nb\n");
    TextFile file(written.path());
    REQUIRE(file.next_line());
    CHECK_THAT(data_error([&] { file.next_line(); }),
               Catch::Contains("start.txt:2: the line is longer than 65536 bytes"));
}

TEST_CASE("a text file starts again after rewind") {
    const WrittenFile written("first\nsecond");
    TextFile file(written.path());
    while (file.next_line()) continue;
    file.rewind();
    REQUIRE(file.next_line());
    CHECK(file.line() == "first");
    CHECK(file.line_number() == 1);
}

TEST_CASE("fields are split at spaces and tabs") {
    std::vector<std::string_view> fields{"old"};
    split_fields("  1\t 2.5  abc ", fields);
    CHECK(fields == std::vector<std::string_view>{"1", "2.5", "abc"});
    split_fields(" \t ", fields);
    CHECK(fields.empty());
}

TEST_CASE("numbers are read whole, in any form that programs write them") {
    const WrittenFile written("x\n");
    TextFile file(written.path());
    REQUIRE(file.next_line());
    CHECK(file.number("-1.126362593256E-01", "x") == -1.126362593256E-01);
    CHECK(file.number("+2", "x") == 2.0);
    CHECK(file.number(".5", "x") == 0.5);
    CHECK(file.number("5e-324", "x") == 5e-324);
    CHECK(file.integer("+17", "n") == 17);
    CHECK(file.integer("9223372036854775807", "n") == 9223372036854775807);

    const auto number_error = [&](std::string_view field) {
        return data_error([&] { (void)file.number(field, "x"); });
    };
    for (const std::string_view field : {"", "abc", "1.5x", "1,5", "0x10", "nan", "inf", "-inf", "+-1", "++1", "1e"}) {
        CAPTURE(field);
        CHECK_THAT(number_error(field), Catch::Contains("start.txt:1: x must be a finite number, found"));
    }
    CHECK_THAT(number_error("1e400"), Catch::Contains("x is outside the range of double precision: '1e400'"));

    const auto integer_error = [&](std::string_view field) {
        return data_error([&] { (void)file.integer(field, "n"); });
    };
    for (const std::string_view field : {"", "abc", "1.5", "1e3", "nan", "+-1"}) {
        CAPTURE(field);
        CHECK_THAT(integer_error(field), Catch::Contains("start.txt:1: n must be an integer, found"));
    }
    CHECK_THAT(integer_error("9223372036854775808"), Catch::Contains("n is outside the range of 64-bit integers"));
}

TEST_CASE("a count that the file has no room for is refused with the number of lines that follow") {
    const WrittenFile written("5\n1\n2");
    TextFile file(written.path());
    REQUIRE(file.next_line());
    CHECK(data_error([&] { file.require_room(2); }) == "no DataError");
    CHECK_THAT(data_error([&] { file.require_room(3); }),
               Catch::Contains("start.txt:1: the file announces 3 atoms, but only 2 lines follow"));
}

TEST_CASE("messages carry the context and show what does not print") {
    const WrittenFile written("a\nb\n");
    TextFile file(written.path());
    file.next_line();
    file.set_context("frame 2: ");
    CHECK(data_error([&] { file.fail("wrong"); }) == written.path().string() + ":1: frame 2: wrong");
    CHECK(data_error([&] { file.fail_at(0, "wrong"); }) == written.path().string() + ": wrong");
    CHECK(shown("a\x01\xff") == "'a\\x01\\xff'");
    CHECK(shown(std::string(41, 'a')) == "'" + std::string(40, 'a') + "...'");
}

TEST_CASE("a file that ends, or ends within a line, is cut there") {
    const WrittenFile written("one\ntwo");
    TextFile file(written.path());
    REQUIRE(file.next_line());
    CHECK_FALSE(file.is_cut());
    REQUIRE(file.next_line());
    CHECK(file.is_cut());
    file.rewind();
    CHECK_FALSE(file.is_cut());
    written.rewrite("one\n");
    TextFile whole(written.path());
    REQUIRE(whole.next_line());
    CHECK_FALSE(whole.is_cut());
    CHECK_FALSE(whole.next_line());
    CHECK(whole.is_cut());
}
