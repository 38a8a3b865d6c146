#include "ljmd/run/footnotes.hpp"

#include <catch2/catch.hpp>

using namespace ljmd;

TEST_CASE("a remark is numbered when it comes first, and told once") {
    Footnotes footnotes;
    CHECK(footnotes.text().empty());
    CHECK(footnotes.mark("too short") == "[1]");
    CHECK(footnotes.mark("") == "");
    CHECK(footnotes.mark("too hot") == "[2]");
    CHECK(footnotes.mark("too short") == "[1]");
    CHECK(footnotes.text() == "  [1] too short\n  [2] too hot\n");
}
