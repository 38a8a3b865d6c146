#include "io/files/text_file.hpp"

#include "catch.hpp"

#include "io/gzipped.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using ljmd::test::data_error;
using ljmd::test::gzipped;
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
}

TEST_CASE("a text that is compressed with gzip is read like any other") {
    using Lines = std::vector<std::string>;
    CHECK(lines_of(gzipped("a\r\nb")) == Lines{"a", "b"});
    CHECK(lines_of(gzipped("\xEF\xBB\xBF"
                           "a\n") +
                   gzipped("b\n")) == Lines{"a", "b"});
    const WrittenFile written(gzipped("first\nsecond\n"));
    TextFile file(written.path());
    while (file.next_line()) continue;
    file.rewind();
    REQUIRE(file.next_line());
    CHECK(file.line() == "first");
    CHECK(file.line_number() == 1);
    CHECK(data_error([&] { file.require_room(100'000); }) == "no DataError");  // there could be as many
    CHECK_THAT(data_error([&] { file.require_room(1'000'000'000); }), Catch::Contains("but only 1 line follows"));
}

TEST_CASE("a compressed text that is cut off, damaged or far too long is refused in the line that it reaches") {
    const std::string packed = gzipped("first\nsecond\n");
    const auto complaint = [](const std::string& bytes, bool is_cut) {
        const WrittenFile written(bytes);
        TextFile file(written.path());
        const std::string message = data_error([&] {
            while (file.next_line()) continue;
        });
        CHECK(file.is_cut() == is_cut);
        return message;
    };
    CHECK_THAT(complaint(packed.substr(0, packed.size() - 1), true),
               Catch::Contains("start.txt:2: the gzip file is cut off"));
    CHECK_THAT(complaint(packed.substr(0, packed.size() - 1) + "x", false), Catch::Contains("is damaged"));
    std::string bomb;
    for (int k = 0; k < 100; ++k) bomb += gzipped(std::string(1'000'000, '\n'));
    CHECK(bomb.size() < 150'000);
    CHECK_THAT(complaint(bomb, false), Catch::Contains("unpacks to more than"));
}

TEST_CASE("what is no text is named in the message") {
    const auto complaint = [](const std::string& bytes) {
        const WrittenFile written(bytes);
        TextFile file(written.path());  // which HDF5 files are opened as, too
        return data_error([&] { file.next_line(); });
    };
    CHECK_THAT(complaint(std::string("\x89HDF\r\n\x1a\n\0\0", 10)), Catch::Contains("start.txt: is an HDF5 file"));
    CHECK_THAT(complaint(gzipped("\x89HDF\r\n\x1a\n")), Catch::Contains("is an HDF5 file"));
    CHECK_THAT(complaint(std::string("a\0b\n", 4)), Catch::Contains("is a binary file"));
    CHECK_THAT(complaint("1\rlattice\r"), Catch::Contains("end in CR alone"));
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
    CHECK(file.number("1.5D+02", "x") == 150.0);  // as Fortran writes double precision
    CHECK(file.number("-0.25d-1", "x") == -0.025);
    CHECK(file.integer("+17", "n") == 17);
    CHECK(file.integer("9223372036854775807", "n") == 9223372036854775807);

    const auto number_error = [&](std::string_view field) {
        return data_error([&] { (void)file.number(field, "x"); });
    };
    for (const std::string_view field : {"", "abc", "1.5x", "1,5", "0x10", "nan", "inf", "-inf", "+-1", "++1", "1e",
                                         "1d", "d2", "1.5D+0D", "0xd", "1.5De2"}) {
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
