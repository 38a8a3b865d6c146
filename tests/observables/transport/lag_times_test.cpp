#include "observables/transport/lag_times.hpp"

#include <string>
#include <utility>
#include <vector>
#include "catch.hpp"

using namespace ljmd;

namespace {

constexpr UsualLags usual{.every = 10, .max_time = 4.0, .share = 0.1};

const SampledRun run{100, Box(Vec3::Constant(5.0)), 0.005, 2000, 1, std::nullopt, std::nullopt};  // 10 tau

using Settings = std::vector<std::pair<std::string, double>>;

LagOptions options_of(const Settings& settings) {
    LagOptions options(usual);
    for (const auto& [key, value] : settings) {
        if (key == "every") {
            options.every = static_cast<Index>(value);
        } else {
            options.max_time = value;
        }
    }
    return options;
}

LagTimes lags_of(const Settings& settings, const SampledRun& sampled = run) {
    return options_of(settings).times(sampled);
}

std::string mistake(const Settings& settings) {
    const Misfits misfits = options_of(settings).check(run, "vacf");
    return misfits.empty() ? "" : misfits.at(0).first + ": " + misfits.at(0).second;
}

}  // namespace

TEST_CASE("without keys the largest time is the usual one, or a share of a short run") {
    CHECK(lags_of({}).every == 10);
    CHECK(lags_of({}).spacing == Approx(0.05));
    CHECK(lags_of({}).count == 20);  // a tenth of 10 tau
    SampledRun longer = run;
    longer.steps = 1000000;
    CHECK(lags_of({}, longer).count == 80);
    CHECK(lags_of({}, longer).time(80) == Approx(4.0));
    SampledRun nothing = run;
    nothing.steps = 0;
    CHECK(lags_of({}, nothing).count == 1);
}

TEST_CASE("the largest time is a whole number of spacings, of which doubles may be a little short") {
    CHECK(lags_of({{"max_time", 2.0}}).count == 40);
    CHECK(lags_of({{"max_time", 2.04}}).count == 40);
    CHECK(lags_of({{"max_time", 0.3}, {"every", 20}}).count == 3);  // 0.3/0.1 is 2.9999999999999996
    CHECK(lags_of({{"max_time", 0.05}, {"every", 3}}).count == 3);
}

TEST_CASE("times that no two configurations of the run are apart are mistakes") {
    CHECK(mistake({}).empty());
    CHECK(mistake({{"max_time", 0.05}}).empty());
    CHECK(mistake({{"max_time", 10.0}}).empty());
    CHECK_THAT(mistake({{"max_time", 0.04}}), Catch::Contains("max_time: 'max_time' in vacf is 0.04") &&
                                                  Catch::Contains("0.05 tau apart") && Catch::Contains("10 steps"));
    CHECK_THAT(mistake({{"max_time", 10.1}}),
               Catch::Contains("'max_time' in vacf is 10.1") && Catch::Contains("no more than 10 tau"));
}

TEST_CASE("a window is twice the largest time long, or a stage, and has every time apart in it") {
    const LagTimes lags = lags_of({{"max_time", 2.0}});  // 40 spacings of 10 steps
    CHECK(correlation_window(lags, run) == 80);
    SampledRun shorter = run;
    shorter.steps = 500;
    CHECK(correlation_window(lags, shorter) == 50);
    shorter.steps = 100;
    CHECK(correlation_window(lags, shorter) == 41);
    CHECK(correlation_window({10, 1, 0.05}, shorter) == 2);
}
