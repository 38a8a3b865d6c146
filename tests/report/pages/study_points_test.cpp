#include "report/pages/study_pages.hpp"

#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("points lead to their directories, and to their reports where there are any") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "points/a");
    overwrite(folder / "points/a/report.html", "");
    const auto run = [&](const std::string& name) {
        return Data{{"name", name},
                    {"directory", (folder / ("points/" + name)).string()},
                    {"state", "finished"},
                    {"words", ""}};
    };
    const Data points = study_points(Data::list({run("a"), run("b")}), folder / "");
    CHECK(points[0]["directory"] == "points/a");
    CHECK(points[0]["href"] == "points/a/report.html");
    CHECK_FALSE(points[1].contains("href"));
}

TEST_CASE("a study is finished when all its runs are") {
    const auto page_of_states = [](int finished, int failed, bool running) {
        PageContent page{.kind = "sweep", .title = "", .source = ""};
        add_study_state(page, {{"running", running},
                               {"states", {{"finished", finished}, {"failed", failed}}},
                               {"runs", Data::list({1, 2, 3})}});
        return page;
    };
    CHECK(page_of_states(3, 0, false).state == "finished");
    CHECK(page_of_states(3, 0, false).verdicts[0].level == "good");
    CHECK(page_of_states(2, 1, false).state == "stopped");
    CHECK(page_of_states(2, 1, false).verdicts[0].level == "bad");
    CHECK(page_of_states(2, 0, true).state == "running");
    CHECK(page_of_states(2, 1, false).state_words == "3 runs: 2 finished, 1 failed");
}
