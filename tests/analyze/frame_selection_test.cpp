#include "analyze/frame_selection.hpp"

#include "catch.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

TrajectorySummary trajectory(const std::vector<Index>& steps, const std::vector<double>& times, Index frames = 0) {
    TrajectorySummary summary{};
    summary.frames = std::max({std::ssize(steps), std::ssize(times), frames});
    summary.steps = steps;
    summary.times = times;
    return summary;
}

FrameSelection select(const TrajectorySummary& summary, std::optional<double> time_step = std::nullopt,
                      std::optional<double> from = std::nullopt) {
    return select_frames(summary, time_step, nullptr, from);
}

}  // namespace

TEST_CASE("all frames of a trajectory are one part, numbered by their steps") {
    const FrameSelection all = select(trajectory({20, 30, 40}, {0.2, 0.3, 0.4}));
    CHECK(all.parts == std::vector<std::optional<std::size_t>>(3, 0));
    CHECK(all.numbers == std::vector<Index>{2, 3, 4});
    CHECK(all.used == 3);
    CHECK(all.longest_part == 3);
    CHECK(all.steps_apart == Index{10});
    CHECK(all.spacing.value() == Approx(0.1));
}

TEST_CASE("frames without steps are counted") {
    const FrameSelection all = select(trajectory({}, {5.0, 5.5, 6.0}));
    CHECK(all.numbers == std::vector<Index>{0, 1, 2});
    CHECK_FALSE(all.steps_apart.has_value());
    CHECK(all.spacing.value() == 0.5);
}

TEST_CASE("times follow from a time step where the file has none") {
    CHECK(select(trajectory({0, 10, 20}, {}), 0.25).spacing.value() == 2.5);
    CHECK(select(trajectory({}, {}, 3), 0.25).spacing.value() == 0.25);
    CHECK(select(trajectory({0, 10, 20}, {0.0, 1.0, 2.0}), 0.25).spacing.value() == 1.0);
    CHECK(select(trajectory({0, 10, 20}, {0.0, 2.50001, 5.0}), 0.25).spacing.value() == 2.5);
    const FrameSelection none = select(trajectory({0, 10, 20}, {}));
    CHECK_FALSE(none.spacing.has_value());
    CHECK_THAT(none.uneven, Contains("no times"));
}

TEST_CASE("a gap between frames is found, rounding in single precision is none") {
    CHECK_THAT(select(trajectory({}, {0, 1, 2, 4})).uneven,
               Contains("frames 1 and 2 are 1 tau apart, frames 3 and 4 are 2 tau"));
    CHECK_FALSE(select(trajectory({}, {0, 1, 1, 2})).spacing.has_value());
    CHECK_FALSE(select(trajectory({}, {0, 0, 0})).spacing.has_value());
    CHECK_FALSE(select(trajectory({}, {2, 1, 0})).spacing.has_value());
    CHECK_FALSE(select(trajectory({}, {1})).spacing.has_value());
    std::vector<double> rounded;
    for (int k = 0; k < 1000; ++k) {
        rounded.push_back(static_cast<double>(1000.0F + 0.1F * static_cast<float>(k)));
    }
    CHECK(select(trajectory({}, rounded)).spacing.value() == Approx(0.1).epsilon(1e-5));
    rounded.erase(rounded.begin() + 700);
    CHECK_FALSE(select(trajectory({}, rounded)).spacing.has_value());
}

TEST_CASE("frames before a time are left out") {
    const FrameSelection late = select(trajectory({0, 10, 20, 30}, {0.0, 0.1, 0.2, 0.3}), std::nullopt, 0.2);
    CHECK(late.used == 2);
    CHECK_FALSE(late.parts[1].has_value());
    CHECK(late.parts[2].has_value());
    CHECK(late.numbers[2] == 2);
    CHECK_THROWS_AS(select(trajectory({0, 10}, {0.0, 0.1}), std::nullopt, 0.2), DataError);
    CHECK_THROWS_AS(select(trajectory({0, 10}, {}), std::nullopt, 0.2), InputError);
}

TEST_CASE("stages of a run are parts, of which the sampled ones are measured") {
    const test::DeckFolder folder;
    const Deck deck = folder.load({"stage.equilibrate.sample=true", "stage.equilibrate.steps=20"});
    const TrajectorySummary run = trajectory({0, 10, 20, 30, 40, 50}, {0.0, 0.04, 0.08, 0.12, 0.16, 0.2});
    const FrameSelection both = select_frames(run, std::nullopt, &deck.stages(), std::nullopt);
    CHECK(both.parts == std::vector<std::optional<std::size_t>>{std::nullopt, 0, 0, 1, 1, 1});
    CHECK(both.used == 5);
    CHECK(both.longest_part == 3);
    const Deck second = folder.load({});
    CHECK(select_frames(run, std::nullopt, &second.stages(), std::nullopt).used == 3);
}

TEST_CASE("what lies between two parts does not make frames unevenly spaced") {
    const test::DeckFolder folder;
    const Deck deck = folder.load({"stage.equilibrate.sample=true"});
    const FrameSelection found = select_frames(trajectory({10, 20, 30, 40}, {0.04, 0.08, 9.0, 9.04}), std::nullopt,
                                               &deck.stages(), std::nullopt);
    CHECK(found.spacing.value() == Approx(0.04));
}

TEST_CASE("what lies between two places where a file was joined is a part of its own") {
    TrajectorySummary joined = trajectory({0, 10, 20, 30, 40}, {0.0, 0.1, 0.2, 0.3, 0.4});
    joined.breaks = {2};
    const FrameSelection all = select(joined);
    CHECK(all.parts[0] == all.parts[1]);
    CHECK(all.parts[1] != all.parts[2]);
    CHECK(all.parts[2] == all.parts[4]);
    CHECK(all.longest_part == 3);
    CHECK(all.spacing.value() == Approx(0.1));
}
