#include "core/terminal_text.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("a terminal gets no control character, and no half of a character") {
    CHECK(harmless_length("a\x1B") == 1);
    CHECK(harmless_length("\xC3\x85") == 2);
    CHECK(harmless_length("\xC2\xA0") == 2);
    CHECK(harmless_length("\xF0\x9F\x98\x80") == 4);
    for (const char* harmful : {"", "\x1B[31m", "\n", "\t", "\x7F", "\xC2\x9B", "\xC2", "\xFF"}) {
        CHECK(harmless_length(harmful) == 0);
    }
}
