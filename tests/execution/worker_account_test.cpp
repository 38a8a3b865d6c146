#include "execution/worker_account.hpp"

#include "catch.hpp"

using namespace ljmd;
using namespace std::chrono_literals;

namespace {

const WorkerAccount::Clock::time_point start{1h};

}  // namespace

TEST_CASE("a worker that saves more than it costs is not left out") {
    WorkerAccount account;
    for (int loop = 0; loop < 1000; ++loop) {
        account.settle(1ms, 900us, start);
        CHECK_FALSE(account.is_left_out(start));
    }
}

TEST_CASE("a worker that is interrupted for less than it has saved in a millisecond is not left out") {
    WorkerAccount account;
    for (int loop = 0; loop < 100; ++loop) {
        for (int good = 0; good < 50; ++good) {
            account.settle(27us, 2us, start);
        }
        account.settle(27us, 900us, start);
        CHECK_FALSE(account.is_left_out(start));
    }
}

TEST_CASE("a worker that has cost more than it saved is left out for ten times the loss") {
    WorkerAccount account;
    account.settle(1ms, 4ms, start);
    CHECK(account.is_left_out(start));
    CHECK(account.is_left_out(start + 29ms));
    CHECK_FALSE(account.is_left_out(start + 31ms));
    // It begins anew.
    account.settle(1ms, 1ms, start + 31ms);
    CHECK_FALSE(account.is_left_out(start + 31ms));
}

TEST_CASE("a worker that loses again at once is left out for longer and longer, up to eighty times the loss") {
    WorkerAccount account;
    WorkerAccount::Clock::time_point now = start;
    for (const auto pause : {30ms, 60ms, 120ms, 240ms, 240ms}) {
        account.settle(1ms, 4ms, now);
        CHECK(account.is_left_out(now + pause - 1ms));
        now += pause + 1ms;
        CHECK_FALSE(account.is_left_out(now));
    }
    // After a time without loss as long as the pause, the pause is short again.
    now += 300ms;
    account.settle(1ms, 4ms, now);
    CHECK_FALSE(account.is_left_out(now + 31ms));
}

TEST_CASE("small losses add up, and of the gains before them a millisecond counts") {
    WorkerAccount account;
    account.settle(1s, 0ms, start);
    int loops = 0;
    while (!account.is_left_out(start) && loops < 1000) {
        account.settle(1us, 3us, start);
        ++loops;
    }
    CHECK(loops == 526);
    CHECK(account.is_left_out(start + 500us));
    CHECK_FALSE(account.is_left_out(start + 550us));
}
