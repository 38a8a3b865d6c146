#include "execution/thread_team.hpp"

#include <pthread.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>
#include "catch.hpp"

using namespace ljmd;
using Catch::Contains;

namespace {

constexpr std::chrono::milliseconds held{50};

/// Processor time of a thread [s].
double processor_seconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A loop of two blocks, the second by the worker: the caller goes on when that has begun.
template <class First, class Second>
void by_caller_and_worker(ThreadTeam& team, First&& first, Second&& second) {
    std::atomic<bool> begun = false;
    team.for_each_block(2, 1, [&](Index block, Index) {
        if (block == 0) {
            while (!begun) {
                std::this_thread::sleep_for(std::chrono::microseconds(100));
            }
            first();
        } else {
            begun = true;
            second();
        }
    });
}

/// Blocks that this thread computes of a loop of so many.
int own_blocks(ThreadTeam& team, int blocks) {
    std::atomic<int> own = 0;
    team.for_each_block(blocks, 1, [&, caller = std::this_thread::get_id()](Index, Index) {
        own += std::this_thread::get_id() == caller ? 1 : 0;
    });
    return own;
}

/// What a child process exits with that this function is called in.
template <class F>
int exit_code_of_child(F&& function) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(function());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("a team calls for each block once, whatever the numbers of threads and blocks") {
    const int threads = GENERATE(1, 2, 3, 8);
    ThreadTeam team(threads);
    CHECK(team.size() == threads);
    for (const Index blocks : {0, 1, 2, 3, 7, 8, 9, 100}) {
        std::vector<int> times(static_cast<std::size_t>(blocks));
        team.for_each_block(blocks, 1, [&](Index block, Index) { ++times[static_cast<std::size_t>(block)]; });
        CHECK(times == std::vector<int>(times.size(), 1));
    }
}

TEST_CASE("who waits for a block that takes 50 ms spends less than 5 ms of processor time") {
    ThreadTeam team(2);
    double before = 0.0;
    by_caller_and_worker(
        team, [&] { before = processor_seconds(CLOCK_THREAD_CPUTIME_ID); }, [] { std::this_thread::sleep_for(held); });
    CHECK(processor_seconds(CLOCK_THREAD_CPUTIME_ID) - before < 5e-3);
}

TEST_CASE("a worker without work for 50 ms spends less than 5 ms of processor time") {
    ThreadTeam team(2);
    clockid_t clock{};
    by_caller_and_worker(
        team, [] {}, [&] { pthread_getcpuclockid(pthread_self(), &clock); });
    const double before = processor_seconds(clock);
    std::this_thread::sleep_for(held);
    CHECK(processor_seconds(clock) - before < 5e-3);
    CHECK(processor_seconds(clock) > 0.0);
}

TEST_CASE("a worker for which the caller has waited in vain is left out for a while") {
    ThreadTeam team(2);
    by_caller_and_worker(
        team, [] {}, [] { std::this_thread::sleep_for(2 * held); });
    CHECK(own_blocks(team, 100) == 100);  // for a second
    while (own_blocks(team, 100) == 100) {
    }
    SUCCEED("it comes back");
}

TEST_CASE("blocks that a worker has not begun are computed by the caller") {
    ThreadTeam team(2);
    // The worker is held in its first block until the caller has computed all others, those of the worker included.
    std::atomic<int> by_caller = 0;
    team.for_each_block(10, 1, [&, caller = std::this_thread::get_id()](Index, Index) {
        if (std::this_thread::get_id() == caller) {
            ++by_caller;
            return;
        }
        while (by_caller < 9) {
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
    });
    CHECK(by_caller >= 9);
}

TEST_CASE("threads get shares of equal work, and each at least one block") {
    const auto others_by_worker = [](const std::vector<std::int64_t>& work_before, Index of_caller) {
        ThreadTeam team(2);  // a new one, which leaves no worker out
        const Index blocks = static_cast<Index>(work_before.size()) - 1;
        std::atomic<Index> by_worker = 0;
        const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(900);
        team.for_each_block(
            blocks, 1,
            [&, caller = std::this_thread::get_id()](Index block, Index) {
                if (std::this_thread::get_id() != caller) {
                    ++by_worker;
                }
                // The caller holds its last block until the worker has computed all others.
                while (block == of_caller - 1 && by_worker < blocks - of_caller &&
                       std::chrono::steady_clock::now() < give_up) {
                    std::this_thread::sleep_for(std::chrono::microseconds(100));
                }
            },
            work_before);
        return by_worker.load();
    };
    CHECK(others_by_worker({0, 8, 9, 10, 11, 12, 13, 14, 15, 16}, 1) == 8);
    CHECK(others_by_worker({0, 1, 2, 3, 4, 5, 6, 7, 8, 16}, 8) == 1);
    CHECK(others_by_worker({0, 1, 1000}, 1) == 1);
    CHECK(others_by_worker({0, 1000, 1001, 1002}, 1) == 2);
    CHECK(others_by_worker({0, 5, 10, 10, 10}, 1) == 3);
    CHECK(others_by_worker({0, 0, 0, 0, 0}, 1) == 3);
}

TEST_CASE("a hundred thousand short loops come to their end, with right sums") {
    const int threads = GENERATE(2, 3, 8);
    ThreadTeam team(threads);
    constexpr int loops = 100000;
    std::array<Index, 16> sums{};
    for (int k = 0; k < loops; ++k) {
        team.for_each_block(16, 1, [&](Index block, Index) { sums[static_cast<std::size_t>(block)] += block + k; });
        if (k % 1000 == 0) {  // long enough that they sleep
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    }
    for (Index block = 0; block < 16; ++block) {
        CHECK(sums[static_cast<std::size_t>(block)] == loops * block + Index{loops} * (loops - 1) / 2);
    }
}

TEST_CASE("the first failing block is the one that is told of, and the team works on") {
    ThreadTeam team(3);
    for (int k = 0; k < 100; ++k) {
        CHECK_THROWS_WITH(team.for_each_block(100, 10,
                                              [](Index first, Index) {
                                                  if (first >= 40) {
                                                      throw std::runtime_error(std::to_string(first));
                                                  }
                                              }),
                          "40");
    }
    CHECK_NOTHROW(team.for_each_block(100, 10, [](Index, Index) {}));
}

TEST_CASE("a loop within a loop, or in another thread, is that thread's alone") {
    ThreadTeam team(3);
    std::atomic<int> inner = 0;
    std::atomic<bool> alone = true;
    const auto loop = [&] {
        const auto caller = std::this_thread::get_id();
        team.for_each_block(5, 1, [&](Index, Index) {
            ++inner;
            alone = alone && std::this_thread::get_id() == caller && number_in_team() == 0;
        });
    };
    team.for_each_block(4, 1, [&](Index block, Index) {
        const int number = number_in_team();
        loop();
        alone = alone && number_in_team() == number;
        if (block == 0) {
            std::thread(loop).join();
        }
    });
    CHECK(inner == 25);
    CHECK(alone);
}

TEST_CASE("threads that are in a loop have numbers of their own below the size of the team") {
    ThreadTeam team(3);
    std::array<std::atomic<int>, 3> inside{};
    std::atomic<bool> sound = true;
    for (int k = 0; k < 1000; ++k) {
        team.for_each_block(10, 1, [&](Index, Index) {
            auto& mine = inside.at(static_cast<std::size_t>(number_in_team()));
            sound = sound && ++mine == 1;
            --mine;
        });
    }
    CHECK(sound);
    CHECK(number_in_team() == 0);
}

TEST_CASE("two teams in two threads do not disturb each other") {
    const auto sum = [] {
        ThreadTeam team(2);
        std::vector<Index> sums(10);
        for (int k = 0; k < 1000; ++k) {
            team.for_each_block(10, 1, [&](Index block, Index) { sums[static_cast<std::size_t>(block)] += k; });
        }
        return std::accumulate(sums.begin(), sums.end(), Index{0});
    };
    Index other = 0;
    std::thread thread([&] { other = sum(); });
    CHECK(sum() == 4995000);
    thread.join();
    CHECK(other == 4995000);
}

TEST_CASE("a child process does without the threads of its parent") {
    ThreadTeam team(4);
    CHECK(exit_code_of_child([&] {
              const int own = own_blocks(team, 20);
              team.~ThreadTeam();
              return own;
          }) == 20);
}

TEST_CASE("a child process may have threads of its own") {
    CHECK(exit_code_of_child([] {
              ThreadTeam team(2);
              int answer = 0;
              by_caller_and_worker(
                  team, [] {}, [&] { answer = 7; });
              return answer;
          }) == 7);
}

TEST_CASE("threads that the system refuses are an error that tells how many it allows") {
    // No process has room for such a stack.
    pthread_attr_t usual;
    pthread_attr_t large;
    REQUIRE(pthread_getattr_default_np(&usual) == 0);
    pthread_attr_init(&large);
    REQUIRE(pthread_attr_setstacksize(&large, std::size_t{1} << 60) == 0);
    REQUIRE(pthread_setattr_default_np(&large) == 0);
    CHECK_THROWS_WITH(ThreadTeam(3), Contains("3 threads are asked for, and the system allows no more than 1"));
    CHECK(pthread_setattr_default_np(&usual) == 0);
    pthread_attr_destroy(&usual);
    pthread_attr_destroy(&large);
}
