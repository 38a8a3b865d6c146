#include "ljmd/execution/execution.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/execution/thread_team.hpp"

namespace ljmd {

namespace {

std::shared_ptr<ThreadTeam> team_of(int threads) {
    if (threads < 1) {
        throw ContractViolation(fmt::format("{} threads", threads));
    }
    return std::make_shared<ThreadTeam>(threads);
}

}  // namespace

Execution::Execution() : Execution(ExecutionOptions{}) {}

Execution::Execution(const ExecutionOptions& options)
    : team_(team_of(options.threads)), simd_(options.simd), precision_(options.precision) {}

int Execution::threads() const {
    return team_->size();
}

}  // namespace ljmd
