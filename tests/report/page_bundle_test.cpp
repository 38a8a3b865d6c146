#include <fstream>
#include <iterator>

#include "catch.hpp"

#include "report/page.hpp"

using namespace ljmd;

namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the program has the files of the page, byte for byte") {
    const std::string page = LJMD_PAGE;
    CHECK((page_bundle().frame == text_of(page + "/index.html")));
    CHECK((page_bundle().style == text_of(page + "/report.css")));
    CHECK((page_bundle().script == text_of(LJMD_PAGE_SCRIPT)));
    CHECK(page_bundle().script.size() > 100);
}

TEST_CASE("the script of the page says by whom its parts are, also when it is shortened") {
    const std::string licences = text_of(std::string(LJMD_PAGE) + "/THIRD-PARTY-LICENSES");
    CHECK(licences.size() > 1000);
    CHECK(page_bundle().script.starts_with("/*!\n" + licences.substr(0, 1000)));
}

TEST_CASE("the page asks for nothing from anywhere, and its script ends no element") {
    const std::string frame(page_bundle().frame);
    CHECK(frame.find("src=") == std::string::npos);
    CHECK(frame.find("href=") == std::string::npos);
    CHECK((page_bundle().script.find("</script") == std::string_view::npos));
    CHECK((page_bundle().style.find("</style") == std::string_view::npos));
    CHECK_NOTHROW(page_html({.kind = "run", .title = "", .source = ""}));
}
