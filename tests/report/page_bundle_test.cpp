#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

#include "ljmd/report/page.hpp"

using namespace ljmd;

namespace {

std::string text_of(const std::string& name) {
    std::ifstream file(std::string(LJMD_INPUTS) + "/../src/report/web/dist/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the program has the files of the page, byte for byte") {
    CHECK((page_bundle().frame == text_of("index.html")));
    CHECK((page_bundle().style == text_of("report.css")));
    CHECK((page_bundle().script == text_of("report.js")));
    CHECK(page_bundle().script.size() > 100);
}

TEST_CASE("the page asks for nothing from anywhere, and its script ends no element") {
    const std::string frame(page_bundle().frame);
    CHECK(frame.find("src=") == std::string::npos);
    CHECK(frame.find("href=") == std::string::npos);
    CHECK((page_bundle().script.find("</script") == std::string_view::npos));
    CHECK((page_bundle().style.find("</style") == std::string_view::npos));
    CHECK_NOTHROW(page_html({.kind = "run", .title = "", .source = ""}));
}
