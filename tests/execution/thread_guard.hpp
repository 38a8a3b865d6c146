#pragma once

#include "ljmd/execution/threads.hpp"

namespace ljmd::test {

/// That many threads until the end of the scope.
class ThreadGuard {
  public:
    explicit ThreadGuard(int count) : before_(thread_count()) { set_thread_count(count); }
    ~ThreadGuard() { set_thread_count(before_); }
    ThreadGuard(const ThreadGuard&) = delete;
    ThreadGuard& operator=(const ThreadGuard&) = delete;

  private:
    int before_;
};

}  // namespace ljmd::test
