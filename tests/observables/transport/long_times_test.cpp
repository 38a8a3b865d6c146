#include "observables/transport/long_times.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

constexpr Index atoms = 12;

/// Atoms that walk at random, with velocities; the same for each walker. Every fifth step of 0.004 tau is sampled.
class Walker {
  public:
    const State& next() {
        std::normal_distribution<double> normal;
        const auto normals = [&] {
            return Eigen::Matrix3Xd(Eigen::Matrix3Xd::NullaryExpr(3, atoms, [&] { return normal(generator_); }));
        };
        state_.write_positions() += 0.1 * normals();
        state_.wrap();
        state_.write_velocities() = normals();
        return state_;
    }

  private:
    std::mt19937_64 generator_{7};
    State state_ = test::random_state(atoms, Box(Vec3::Constant(6.0)), 1);
};

SampledRun run() {
    return test::run_of(test::random_state(atoms, Box(Vec3::Constant(6.0)), 1));  // 40 tau
}

std::unique_ptr<Analysis> made(const std::string& name, const test::AnalysisSettings& settings) {
    return test::analysis_options(test::analysis_method(name), settings)->make(run());
}

std::vector<DataTable> sampled(Analysis& analysis, int frames, int thinned = 1) {
    Walker walker;
    for (int frame = 0; frame < frames; ++frame) {
        const State& state = walker.next();
        if (frame % thinned == 0) {
            analysis.sample(state, {});
        }
    }
    return analysis.tables();
}

test::AnalysisSettings settings(double max_time, std::int64_t every = 5) {
    test::AnalysisSettings all{{"every", every}, {"max_time", max_time}, {"origins", std::int64_t{5}}};
    return all;
}

}  // namespace

TEST_CASE("levels double the spacing until the longest time is reached") {
    LongTimeOption option;
    const LagTimes lags{.every = 5, .count = 10, .spacing = 0.02};
    CHECK(option.levels(lags).size() == 1);
    option.long_time = 1.6;
    const auto levels = option.levels(lags);
    REQUIRE(levels.size() == 4);
    CHECK(levels[3].every == 40);
    CHECK(levels[3].spacing == 0.16);
    CHECK(levels[3].count == 10);
    option.long_time = 1.0;
    REQUIRE(option.levels(lags).size() == 4);
    CHECK(option.levels(lags)[3].count == 6);  // 0.96
    option.long_time = 0.21;                   // no multiple of 0.04 lies between 0.20 and this
    CHECK(option.levels(lags).size() == 1);
    option.long_time = 1e300;
    CHECK(option.levels(lags).size() < 64);
}

TEST_CASE("long times go on where the first level ends, with every second, fourth, eighth configuration") {
    const std::string name = GENERATE("msd", "scattering");
    CAPTURE(name);
    auto with = settings(0.2);
    with.emplace_back("long_time", 1.6);
    const auto plain = made(name, settings(0.2));
    const auto both = made(name, with);
    const auto short_times = sampled(*plain, 700);
    const auto tables = sampled(*both, 700);
    CHECK(both->samples() == 700);
    CHECK(both->due(5));
    CHECK_FALSE(both->due(6));
    REQUIRE(tables.size() == short_times.size());
    for (std::size_t k = 0; k < tables.size(); ++k) {
        const bool has_time = tables[k].name != "skw" && tables[k].name != "modes";
        const std::size_t time = tables[k].name == "msd" ? 0 : 1;
        const std::size_t groups = name == "msd" ? 1 : short_times[k].rows.size() / 11;
        if (!has_time) {
            CHECK(fmt::format("{}", tables[k].rows) == fmt::format("{}", short_times[k].rows));
            continue;
        }
        REQUIRE(short_times[k].rows.size() == 11 * groups);
        REQUIRE(tables[k].rows.size() == (11 + 3 * 5) * groups);
        for (std::size_t group = 0; group < groups; ++group) {
            const auto begin = tables[k].rows.begin() + static_cast<std::ptrdiff_t>(26 * group);
            const auto from = short_times[k].rows.begin() + static_cast<std::ptrdiff_t>(11 * group);
            CHECK(std::equal(from, from + 11, begin));  // the first level keeps its bits
        }
        for (int level = 1; level < 4; ++level) {
            const int m = 1 << level;
            // The same numbers as of a run whose trajectory has every m-th configuration alone.
            const auto thinned = made(name, settings(0.2 * m, std::int64_t{5} * m));
            const auto wanted = sampled(*thinned, 700, m).at(k);
            for (std::size_t group = 0; group < groups; ++group) {
                for (std::size_t lag = 6; lag <= 10; ++lag) {
                    const auto& row =
                        tables[k].rows[26 * group + 11 + static_cast<std::size_t>(5 * (level - 1)) + lag - 6];
                    CHECK(row == wanted.rows[11 * group + lag]);
                    CHECK(row[time] == Approx(0.02 * m * static_cast<double>(lag)));
                }
            }
        }
    }
    if (name == "msd") {
        CHECK(both->observables().at(0).estimate->mean == plain->observables().at(0).estimate->mean);
    }
}

TEST_CASE("long times end at the last one that was asked for") {
    auto with = settings(0.2);
    with.emplace_back("long_time", 1.0);
    const auto rows = sampled(*made("msd", with), 200).at(0).rows;
    CHECK(rows.back()[0] == Approx(0.96));
    REQUIRE(rows.size() == 11 + 5 + 5 + 1);
}

TEST_CASE("long times go on from an archive bit for bit, and an interruption begins all levels anew") {
    auto with = settings(0.2);
    with.emplace_back("long_time", 1.6);
    const auto rows = [&](int interrupted_at, int archived_at) {
        auto analysis = made("scattering", with);
        Walker walker;
        for (int frame = 0; frame < 200; ++frame) {
            if (frame == interrupted_at) {
                analysis->interrupt();
            }
            if (frame == archived_at) {
                auto restored = made("scattering", with);
                test::through_archive(*analysis, *restored);
                analysis = std::move(restored);
            }
            analysis->sample(walker.next(), {});
        }
        return analysis->tables().at(1).rows;
    };
    const auto whole = rows(-1, -1);
    CHECK(rows(-1, 33) == whole);
    CHECK(rows(-1, 150) == whole);
    CHECK(rows(33, -1) != whole);
    CHECK(rows(33, 61) == rows(33, -1));
}

TEST_CASE("a long time that adds nothing, or is longer than the run, is a mistake, and memory is told") {
    const std::string name = GENERATE("msd", "scattering", "vacf");
    const auto options = [&](double long_time) {
        return test::analysis_options(test::analysis_method(name), {{"max_time", 2.0}, {"long_time", long_time}});
    };
    CHECK(options(40.0)->check(run()).empty());
    REQUIRE(options(41.0)->check(run()).size() == 1);
    CHECK(options(41.0)->check(run())[0].first == "long_time");
    CHECK_THAT(options(41.0)->check(run())[0].second, Catch::Contains("no more than 40 tau"));
    REQUIRE(options(2.0)->check(run()).size() == 1);
    CHECK_THAT(options(2.0)->check(run())[0].second, Catch::Contains("up to 2 are measured without it"));
    const double plain = test::analysis_options(test::analysis_method(name), {{"max_time", 2.0}})->size(run()).kept;
    CHECK(options(16.0)->size(run()).kept > 1.5 * plain);
    CHECK(options(16.0)->size(run()).kept < 4.5 * plain);
}
