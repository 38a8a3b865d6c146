#include "run/footnotes.hpp"

#include "catch.hpp"

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

TEST_CASE("a long remark goes on in the next line, below its beginning") {
    Footnotes footnotes;
    static_cast<void>(footnotes.mark(std::string(70, 'a') + " it ends here"));
    CHECK(footnotes.text() == "  [1] " + std::string(70, 'a') + " it\n      ends here\n");
}
