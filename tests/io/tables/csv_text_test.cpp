#include "io/tables/csv_text.hpp"

#include "catch.hpp"

using namespace ljmd;
using Fields = std::vector<std::string>;

TEST_CASE("a line of CSV has its fields, in quotes or not") {
    CHECK(csv_fields("a,b,c") == Fields{"a", "b", "c"});
    CHECK(csv_fields(" a b ,\t\"c, d\" ") == Fields{"a b", "c, d"});
    CHECK(csv_fields(R"("[1.0, 0.0]","say ""yes""",x"y)") == Fields{"[1.0, 0.0]", R"(say "yes")", "x\"y"});
    CHECK(csv_fields("") == Fields{""});
    CHECK(csv_fields(",") == Fields{"", ""});
    CHECK(csv_fields("\"\",") == Fields{"", ""});
    CHECK(csv_fields("1,") == Fields{"1", ""});
}

TEST_CASE("a quote that is left open, or closed too early, makes a line no CSV") {
    for (const char* line : {"\"", "a,\"b", "\"a\"b", "\"a\" \"b\",c", "\"a\"\""}) {
        INFO(line);
        CHECK_FALSE(csv_fields(line).has_value());
    }
}

TEST_CASE("any text is read back from the field that it makes") {
    for (const char* text : {"", "1.5", "86.5 K", "a,b", "\"", "\"a\",", "[1.0, 0.0]", "\xC3\x85", "a\"b"}) {
        INFO(text);
        CHECK(csv_fields(csv_field(text) + "," + csv_field(text)) == Fields{text, text});
    }
    CHECK(csv_field("86.5 K") == "86.5 K");
    CHECK(csv_field("a,b") == "\"a,b\"");
}
