#include "report/page.hpp"

#include "catch.hpp"

#include "io/tables/json_text.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

constexpr PageBundle bundle{
    "<style>/*ljmd:css*/</style><script id=d>/*ljmd:data*/</script><script>/*ljmd:js*/</script>", "body {}", "run()"};

}  // namespace

TEST_CASE("no text ends the element that the data are in, and the data say what they said") {
    const std::string hostile = "</script><script>alert(1)</script><!-- \xE2\x80\xA8 \xE2\x80\xAE & \" /*ljmd:js*/";
    const std::string text = json_for_html({{"title", hostile}});
    CHECK(text.find('<') == std::string::npos);
    CHECK(parse_json(text)["title"] == hostile);
    for (const char letter : text) {
        CHECK(static_cast<unsigned char>(letter) < 0x80);
    }
}

TEST_CASE("each part stands in its place, also where a text looks like a place") {
    const std::string page = page_html({.kind = "run", .title = "/*ljmd:js*/ </script>", .source = ""}, bundle);
    CHECK_THAT(page, Catch::StartsWith("<style>body {}</style><script id=d>{\"format\":\"ljmd-report\""));
    CHECK_THAT(page, Catch::EndsWith("}</script><script>run()</script>"));
    CHECK_THAT(page, Contains("/*ljmd:js*/ \\u003c/script>"));
    CHECK_THROWS_AS(page_html({.kind = "run", .title = "", .source = ""}, {"<html>", "", ""}), ContractViolation);
}
