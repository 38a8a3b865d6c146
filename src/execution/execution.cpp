#include "ljmd/execution/execution.hpp"

#include <fmt/format.h>

#include <string>

#include "execution/ranks.hpp"
#include "execution/thread_team.hpp"
#include "execution/threads.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

std::shared_ptr<ThreadTeam> team_of(int threads) {
    if (threads < 1 || threads > max_threads) {
        throw InputError(fmt::format("{} threads: allowed are 1 to {}", threads, max_threads));
    }
    return std::make_shared<ThreadTeam>(threads);
}

}  // namespace

Execution::Execution() : Execution(ExecutionOptions{}) {}

Execution::Execution(const ExecutionOptions& options)
    : team_(team_of(options.threads)),
      simd_(usable_simd_level(std::string(name(options.simd)))),
      precision_(options.precision),
      ranks_(options.ranks) {}

Ranks& Execution::ranks() const {
    return ranks_ ? *ranks_ : no_other_ranks();
}

Execution Execution::alone() const {
    Execution copy = *this;
    copy.ranks_.reset();
    return copy;
}

int Execution::threads() const {
    return team_->size();
}

}  // namespace ljmd
