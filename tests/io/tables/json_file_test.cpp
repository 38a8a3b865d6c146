#include "io/tables/json_file.hpp"

#include <limits>
#include "catch.hpp"

#include "io/tables/json_text.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// The number n in a file, from 1 to 5.
Index read_n(const std::filesystem::path& path) {
    return read_json(path, "a number in a file", [](const Data& json) { return integer_of(json.at("n"), "n", 1, 5); });
}

std::string complaint(const std::string& text) {
    const WrittenFile file(text, "n.json");
    return data_error([&] { static_cast<void>(read_n(file.path())); });
}

}  // namespace

TEST_CASE("an integer in a JSON file is read, and what is none is refused with file and cause") {
    CHECK(read_n(WrittenFile("{\"n\": 3}").path()) == 3);
    for (const char* value :
         {"0", "6", "-9223372036854775808", "18446744073709551615", "1e300", "2.0", "true", "\"3\""}) {
        CAPTURE(value);
        CHECK_THAT(
            complaint(fmt::format("{{\"n\": {}}}", value)),
            Contains("n.json is not a number in a file: 'n' is ") && Contains("allowed: an integer from 1 to 5"));
    }
    CHECK_THAT(complaint("{\"n\": \"\xff\"}"), Contains("n.json is not a number in a file: "));
    CHECK_THAT(complaint("{\"n\": {}}"), Contains("'n' is {}"));
}

TEST_CASE("what is no JSON, or has not what is wanted, is refused in the words of the library, without its numbers") {
    CHECK_THAT(complaint("{\"m\": 3}"), Contains("n.json is not a number in a file: key 'n' not found"));
    CHECK_THAT(complaint("{"), Contains("n.json is not a number in a file: parse error at line 1"));
    CHECK_THAT(data_error([] { static_cast<void>(read_n("/dev/zero")); }), Contains("/dev/zero: is a device"));
}

TEST_CASE("a file larger than any record is not read to its end") {
    const WrittenFile file("", "n.json");
    std::filesystem::resize_file(file.path(), max_json_bytes + 1);  // takes no disk
    CHECK_THAT(data_error([&] { static_cast<void>(read_n(file.path())); }),
               Contains("n.json is not a number in a file: it has more than 64 MiB"));
}

TEST_CASE("texts are those of an array, and no more than asked for") {
    CHECK(texts_of(parse_json(R"(["a", "b"])"), "s", 2) == std::vector<std::string>{"a", "b"});
    CHECK_THROWS_WITH(texts_of(parse_json(R"(["a", "b"])"), "s", 1), "'s' is no array, or has more than 1 texts");
    CHECK_THROWS_AS(texts_of(parse_json(R"({"a": "b"})"), "s", 5), WrongData);
    CHECK_THROWS_AS(texts_of(parse_json(R"([1])"), "s", 5), WrongData);
}
