#include "options/toml_writer.hpp"

#include <memory>
#include "catch.hpp"

#include "input/toml_text.hpp"
#include "ljmd/options/settings.hpp"

using namespace ljmd;

namespace {

Table parsed(const std::string& text) {
    Diagnostics diagnostics;
    const auto table = parse_toml(std::make_shared<const Source>(Source{"a text", text}), diagnostics);
    diagnostics.throw_if_errors();
    return table.value();
}

}  // namespace

TEST_CASE("what is written as TOML is read as it was") {
    for (const std::string text : {"", "plain", "it's \"quoted\" C:\\n", "tab\t line\n \x7f\x01", "\u00e9"}) {
        CHECK(std::get<std::string>(parsed("a = " + toml_string(text)).front().value.data) == text);
    }
    const Table table{
        entry_of("title", std::string("\"x\"")),
        entry_of("one", Table{entry_of("a", 0.1), entry_of("b c", true), entry_of("list", Array{{1.5, {}}, {2.0, {}}}),
                              entry_of("inner", Table{entry_of("n", std::int64_t{-3}), entry_of("none", Table{})})}),
        entry_of("many", Array{{Table{entry_of("k", std::int64_t{1})}, {}}, {Table{entry_of("k", -1e300)}, {}}}),
        entry_of("last", std::int64_t{7})};
    const std::string text = toml_document(table);
    CHECK(
        text ==
        "title = \"\\\"x\\\"\"\nlast = 7\n\n[one]\na = 0.1\n\"b c\" = true\nlist = [1.5, 2.0]\ninner = { n = -3, none "
        "= {} "
        "}\n\n[[many]]\nk = 1\n\n[[many]]\nk = -1e+300\n");
    CHECK(toml_document(parsed(text)) == text);
    CHECK(std::get<double>(std::get<Table>(parsed(text)[2].value.data).front().value.data) == 0.1);
}
