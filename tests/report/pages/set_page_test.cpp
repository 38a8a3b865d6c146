#include "report/pages/set_page.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("members are named after their directories, those of one name by their paths") {
    const auto member = [](const std::string& source, const std::string& state) {
        return PageContent{.kind = "run", .title = "", .source = source, .state = state};
    };
    const PageContent page =
        set_page({member("runs/a/", "finished"), member("runs/b", "finished"), member("other/b", "stopped")});
    CHECK(page.kind == "set");
    CHECK(page.state == "stopped");
    CHECK(page.state_words == "2 of 3 are finished");
    REQUIRE(page.members.size() == 3);
    CHECK(page.members[0].first == "a");
    CHECK(page.members[1].first == "2: runs/b");
    CHECK(page.members[2].first == "3: other/b");
    CHECK(page.members[2].second.source == "other/b");
    CHECK(set_page({member("x", "finished"), member("y", "finished")}).state == "finished");
}
