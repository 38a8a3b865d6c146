#include "io/tables/pair_table_file.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

TabulatedPair some_pair() {
    return {.name = "soft \"core\" \u00e9",
            .truncation = "switched",
            .cutoff = {2.1, 1.7},
            .first = 0.1,
            .energies = {1.0 / 3.0, -0.0, 5e-324, 1.7976931348623157e308, 3.0, -1e-9, 0.1, 0.0},
            .error = 3e-10,
            .force_error = 1e-7};
}

std::string text_of_some_pair() {
    const WrittenFile file("", "given-potential.json");
    write_pair_table(file.path(), some_pair());
    return content_of(file.path());
}

std::string refusal_of(const std::string& text, const std::string& checksum = checksum_of(some_pair())) {
    const WrittenFile file(text, "given-potential.json");
    return data_error([&] { static_cast<void>(read_pair_table(file.path(), checksum)); });
}

std::string with_change(std::string text, const std::string& old, const std::string& with) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), with);
}

}  // namespace

TEST_CASE("a table of a pair potential is read back with the same bits") {
    const WrittenFile file(text_of_some_pair(), "given-potential.json");
    const TabulatedPair expected = some_pair();
    const TabulatedPair found = read_pair_table(file.path(), checksum_of(expected));
    CHECK(found.name == expected.name);
    CHECK(found.truncation == expected.truncation);
    CHECK(found.cutoff.radius == expected.cutoff.radius);
    CHECK(found.cutoff.switch_start == expected.cutoff.switch_start);
    CHECK(found.first == expected.first);
    CHECK(found.energies == expected.energies);
    CHECK(std::signbit(found.energies[1]));
    CHECK(found.error == expected.error);
    CHECK(found.force_error == expected.force_error);
}

TEST_CASE("an error that is not known is read back as that") {
    TabulatedPair pair = some_pair();
    pair.force_error = std::numeric_limits<double>::quiet_NaN();
    const WrittenFile file("", "given-potential.json");
    write_pair_table(file.path(), pair);
    CHECK(std::isnan(read_pair_table(file.path(), checksum_of(pair)).force_error));
}

TEST_CASE("a checksum tells all values of a table") {
    const std::string checksum = checksum_of(some_pair());
    TabulatedPair other = some_pair();
    other.energies[2] = 0.0;
    CHECK(checksum_of(other) != checksum);
    other = some_pair();
    other.first = std::nextafter(other.first, 1.0);
    CHECK(checksum_of(other) != checksum);
    other = some_pair();
    other.truncation = "cut";
    CHECK(checksum_of(other) != checksum);
}

TEST_CASE("a table that is damaged, cut off, another one or none is refused with path and cause") {
    const std::string text = text_of_some_pair();
    CHECK_THAT(refusal_of(with_change(text, "0.3333333333333333", "0.3333333333333334")),
               Contains("given-potential.json is not the table of a pair potential: it is damaged"));
    CHECK_THAT(refusal_of(with_change(text, "switched", "cut")), Contains("it is damaged"));
    CHECK_THAT(refusal_of(text, "xxh3:0123456789abcdef"), Contains("it is another one: its checksum is xxh3:"));
    CHECK_THAT(refusal_of(with_change(text, "\"version\": 1", "\"version\": 2")),
               Contains("it has version 2, and this program reads version 1"));
    CHECK_THAT(refusal_of(with_change(text, "ljmd pair table", "a pair table")), Contains("it is another file"));
    CHECK_THAT(refusal_of("{}"), Contains("it is another file"));
    CHECK_THAT(refusal_of(text.substr(0, text.size() / 2)), Contains("parse error"));
    CHECK_THAT(data_error([] { static_cast<void>(read_pair_table("/nowhere/given-potential.json", "")); }),
               Contains("/nowhere/given-potential.json: no such file"));
    for (std::size_t length = 0; length + 2 < text.size(); ++length) {
        CAPTURE(length);
        CHECK(refusal_of(text.substr(0, length)) != "no DataError");
    }
}
