#include "execution/caller_account.hpp"

#include "catch.hpp"

using namespace ljmd;
using namespace std::chrono_literals;

namespace {

using Nanoseconds = CallerAccount::Nanoseconds;

/// A caller whose loops follow each other, with a clock of its own.
struct Loops {
    CallerAccount account;
    CallerAccount::Clock::time_point now{1h};
    Nanoseconds processor{7e9};
    int readings = 0;

    /// A loop during which the caller had a processor for a part of the time.
    CallerAccount::Loss loop(CallerAccount::Clock::duration length, double part, bool alone, Nanoseconds waited = {}) {
        const auto began = now;
        now += length;
        processor += part * Nanoseconds(length);
        return account.settle(began, now, alone, waited, [this] {
            ++readings;
            return processor;
        });
    }
    Nanoseconds loops(int count, CallerAccount::Clock::duration length, double part, bool alone) {
        Nanoseconds lost{0};
        for (int k = 0; k < count; ++k) {
            lost += loop(length, part, alone).by_team;
        }
        return lost;
    }
};

}  // namespace

TEST_CASE("a caller that has its processor all the time loses nothing, and the clock is read every 200 microseconds") {
    Loops loops;
    CHECK(loops.loops(1001, 20us, 1.0, false) == Nanoseconds{0});
    CHECK(loops.readings == 101);
}

TEST_CASE("what the caller loses with workers, and not alone, is the team's doing") {
    Loops loops;
    loops.loops(1000, 20us, 1.0, true);
    CHECK(loops.loops(1001, 20us, 0.5, false).count() == Approx(0.5 * 20e6));
}

TEST_CASE("what the caller loses alone as well is not the team's doing") {
    Loops loops;
    loops.loops(1000, 20us, 0.75, true);
    CHECK(loops.loops(1001, 20us, 0.75, false).count() == Approx(0.0).margin(1.0));
    CHECK(loops.loops(1000, 20us, 0.5, false).count() == Approx(0.25 * 20e6).epsilon(0.01));
}

TEST_CASE("how busy the other programs were long ago is forgotten") {
    Loops loops;
    loops.loops(20000, 20us, 0.5, true);
    loops.loops(20000, 20us, 1.0, true);
    CHECK(loops.loops(1001, 20us, 0.5, false).count() == Approx(0.5 * 20e6).epsilon(0.1));
}

TEST_CASE("time between loops, and time that the caller waits for workers, is no loss of this kind") {
    Loops loops;
    loops.loops(10, 20us, 1.0, false);
    loops.now += 30ms;  // it reads a file, or sleeps
    CHECK(loops.loops(20, 20us, 1.0, false) == Nanoseconds{0});
    CHECK(loops.loop(3ms, 0.0, false, 3ms).by_team == Nanoseconds{0});
    CHECK(loops.loop(3ms, 0.0, false, 1ms).by_team.count() == Approx(2e6));
}
