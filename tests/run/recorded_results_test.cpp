#include "run/recorded_results.hpp"

#include <fmt/format.h>

#include <cmath>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("means are read from the results of a run, in their order") {
    const TemporaryFolder folder;
    const auto path = folder / "results.json";
    std::ofstream(path) << R"({"observables": {"temperature": {"mean": 1.5, "standard_error": 0.1, "unit": ""},
                                               "pressure": {"mean": null, "standard_error": null, "remark": "one atom"}},
                               "analysis": {"orbit": {"period": {"value": 3, "standard_error": null}}},
                               "stages": [], "doubts": ["a crystal"]})";
    const std::vector<ObservedMean> found = read_results(path).means;
    CHECK(read_results(path).doubts == std::vector<std::string>{"a crystal"});
    REQUIRE(found.size() == 3);
    CHECK(found[0].name == "temperature");
    CHECK(found[0].mean == 1.5);
    CHECK(found[0].standard_error == 0.1);
    CHECK(found[1].name == "pressure");
    CHECK(std::isnan(found[1].mean));
    CHECK(found[0].remark.empty());
    CHECK(found[1].remark == "one atom");
    CHECK(found[2].name == "orbit_period");
    CHECK(found[2].mean == 3.0);
    CHECK(std::isnan(found[2].standard_error));
}

TEST_CASE("results that are not there or damaged are told of") {
    const TemporaryFolder folder;
    const auto path = folder / "results.json";
    CHECK_THROWS_WITH(read_results(path), Contains("results.json: no such file"));
    for (const char* text : {"", "[]", "{}", R"({"observables": {"temperature": 1}})",
                             R"({"observables": {"temperature": {"mean": "x", "standard_error": 1}}})"}) {
        INFO(text);
        std::ofstream(path) << text;
        CHECK_THROWS_AS(read_results(path), DataError);
    }
}

TEST_CASE("results that hold something else than a run writes are refused") {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& text) {
        std::ofstream(folder / "results.json") << text;
        CHECK_THROWS_WITH(read_results(folder / "results.json"), Contains("results.json is not the result of a run: "));
    };
    refused(R"({"observables": [{"mean": 1, "standard_error": 0.1}]})");
    refused(R"({"observables": {}, "analysis": [[{"value": 1, "standard_error": 0.1}]]})");
    refused(R"({"observables": {}, "analysis": {"orbit": [{"value": 1, "standard_error": 0.1}]}})");
    refused(R"({"observables": {"a": 1}})");
    refused(R"({"observables": {"a": {"mean": "1", "standard_error": null}}})");
    std::string many = R"({"observables": {}, "analysis": {)";
    for (int analysis = 0; analysis < 3; ++analysis) {
        many +=
            fmt::format(R"({}"a{}": {{"b0": {{"value": 1, "standard_error": 1}})", analysis == 0 ? "" : ", ", analysis);
        for (int k = 1; k < 500; ++k) {
            many += fmt::format(R"(, "b{}": {{"value": 1, "standard_error": 1}})", k);
        }
        many += "}";
    }
    refused(many + "}}");
}

TEST_CASE("stages are read from the results of a run, and what is none is refused") {
    const TemporaryFolder folder;
    const auto path = folder / "results.json";
    const auto write = [&](const std::string& stages) {
        std::ofstream(path) << fmt::format(R"({{"observables": {{}}, "stages": {}}})", stages);
    };
    write(R"([{"sampled": false, "first_step": 0, "steps": 100}, {"sampled": true, "first_step": 100, "steps": 80}])");
    const std::vector<RecordedStage> stages = read_results(path).stages;
    REQUIRE(stages.size() == 2);
    CHECK_FALSE(stages[0].sampled);
    CHECK(stages[1].sampled);
    CHECK(stages[1].first_step == 100);
    CHECK(stages[1].steps == 80);
    for (const char* wrong : {"{}", "[1]", R"([{"sampled": 1, "first_step": 0, "steps": 1}])",
                              R"([{"sampled": true, "first_step": -1, "steps": 1}])",
                              R"([{"sampled": true, "first_step": 0, "steps": 1.5}])"}) {
        INFO(wrong);
        write(wrong);
        CHECK_THROWS_WITH(read_results(path), Contains("results.json is not the result of a run: "));
    }
}
