#include "io/formats/one_kind.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("atoms of one kind have one value in each column that tells kinds apart") {
    OneKind kind;
    CHECK(kind.add("species", "Ar").empty());
    CHECK(kind.add("species", "Ar").empty());
    CHECK(kind.add("type", "1").empty());
    CHECK(kind.add("species", "Kr") == "species 'Kr' beside 'Ar', but ljmd has one kind of atom");
    CHECK(kind.add("type", "2") == "type '2' beside '1', but ljmd has one kind of atom");
    CHECK(kind.add("type", "1").empty());
}

TEST_CASE("numbers are the same within their rounding, words are not numbers") {
    OneKind kind;
    CHECK(kind.add("mass", "39.948").empty());
    CHECK(kind.add("mass", "39.94800").empty());
    CHECK(kind.add("mass", "39.9479980469").empty());
    CHECK_FALSE(kind.add("mass", "39.95").empty());
    CHECK_FALSE(kind.add("mass", "nan").empty());
    CHECK_FALSE(kind.add("mass", "39.948u").empty());
}

TEST_CASE("columns that tell kinds apart are known in all formats, and a coordinate is none of them") {
    for (const char* name :
         {"type", "element", "species", "mass", "masses", "Z", "numbers", "typelabel", "diameter", "Species", "MASS"}) {
        CAPTURE(name);
        CHECK(OneKind::distinguishes_kinds(name));
    }
    for (const char* name : {"z", "x", "id", "vx", "charge", "pos"}) {
        CAPTURE(name);
        CHECK_FALSE(OneKind::distinguishes_kinds(name));
    }
}
