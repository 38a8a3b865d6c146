#include "io/files/shown_path.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("a message calls a path by the name that the user knows, everywhere") {
    CHECK(shown_as("/tmp/a/x.csv:3: a; /tmp/a/y.csv", "/tmp/a", "{output}") == "{output}/x.csv:3: a; {output}/y.csv");
    CHECK(shown_as("/tmp/b/x.csv", "/tmp/a", "{output}") == "/tmp/b/x.csv");
    CHECK(shown_as("/a/a/a", "/a", "/a/a") == "/a/a/a/a/a/a");
}

TEST_CASE("only what is wrong with the content of files is said of another name") {
    CHECK(read_as("/tmp/a", "mine", [] { return 3; }) == 3);
    CHECK_THROWS_WITH(read_as("/tmp/a", "mine", []() -> int { throw DataError("/tmp/a/x has no row"); }),
                      "mine/x has no row");
    CHECK_THROWS_WITH(read_as("/tmp/a", "mine", []() -> int { throw FileError("/tmp/a/x: disk full"); }),
                      "/tmp/a/x: disk full");
}
