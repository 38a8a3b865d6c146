#include "execution/worker_account.hpp"

#include <catch2/catch.hpp>

using namespace ljmd;
using namespace std::chrono_literals;

namespace {

const WorkerAccount::Clock::time_point start{1h};

}  // namespace

TEST_CASE("a helper that saves more than it costs stays") {
    WorkerAccount account;
    for (int loop = 0; loop < 1000; ++loop) {
        account.settle(1ms, 900us, start);
        CHECK_FALSE(account.on_leave(start));
    }
}

TEST_CASE("a helper that has cost more than it saved is on leave for ten times the loss") {
    WorkerAccount account;
    account.settle(1ms, 4ms, start);
    CHECK(account.on_leave(start));
    CHECK(account.on_leave(start + 29ms));
    CHECK_FALSE(account.on_leave(start + 31ms));
    // It begins anew.
    account.settle(1ms, 1ms, start + 31ms);
    CHECK_FALSE(account.on_leave(start + 31ms));
}

TEST_CASE("a worker that loses again at once is on leave for longer and longer, up to eighty times the loss") {
    WorkerAccount account;
    WorkerAccount::Clock::time_point now = start;
    for (const auto leave : {30ms, 60ms, 120ms, 240ms, 240ms}) {
        account.settle(1ms, 4ms, now);
        CHECK(account.on_leave(now + leave - 1ms));
        now += leave + 1ms;
        CHECK_FALSE(account.on_leave(now));
    }
    // A worker that was good for as long as it was away is trusted again.
    now += 300ms;
    account.settle(1ms, 4ms, now);
    CHECK_FALSE(account.on_leave(now + 31ms));
}

TEST_CASE("small losses add up, and gains before them do not count") {
    WorkerAccount account;
    account.settle(1s, 0ms, start);
    int loops = 0;
    while (!account.on_leave(start) && loops < 1000) {
        account.settle(1us, 3us, start);
        ++loops;
    }
    CHECK(loops == 26);
    CHECK(account.on_leave(start + 500us));
    CHECK_FALSE(account.on_leave(start + 550us));
}
