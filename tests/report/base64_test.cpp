#include "report/base64.hpp"

#include <cstdint>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("base64 of the examples in RFC 4648, and of numbers byte by byte") {
    const auto of = [](const std::string& text) { return base64(std::as_bytes(std::span(text))); };
    CHECK(of("").empty());
    CHECK(of("f") == "Zg==");
    CHECK(of("fo") == "Zm8=");
    CHECK(of("foo") == "Zm9v");
    CHECK(of("foobar") == "Zm9vYmFy");
    CHECK(of("\xff\xff\xff") == "////");
    CHECK(base64(std::vector<std::uint16_t>{0x6F66, 0x626F}) == of("foob"));  // little-endian
}
