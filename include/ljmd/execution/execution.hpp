#pragma once

#include <memory>

#include "ljmd/detail/execution/simd.hpp"

namespace ljmd {

class Ranks;
class ThreadTeam;

/// What an Execution is made of.
struct ExecutionOptions {
    int threads = 1;
    SimdLevel simd = default_simd_level();
    Precision precision = Precision::double_precision;
    std::shared_ptr<Ranks> ranks = nullptr;  ///< the processes that share the system; null: this one alone
};

/// How a system is computed: threads, SIMD level of the kernels, precision of the pair sum, and the processes that
/// share it. It is given to whatever computes (State holds it), so that systems with different settings can be computed
/// in one process, also at the same time. No result depends on the number of threads or processes.
///
/// A value: copies are equal and share one team of threads, which ends with the last of them.
class Execution {
  public:
    /// One thread, the default SIMD level, double precision. @throws InputError as default_simd_level()
    Execution();
    /// @throws InputError for a number of threads that is not 1 to max_threads, and for a SIMD level that this
    /// processor cannot run; ThreadsError if the system refuses that many threads
    explicit Execution(const ExecutionOptions& options);

    /// Number of threads, at least 1.
    [[nodiscard]] int threads() const;
    [[nodiscard]] SimdLevel simd() const { return simd_; }
    [[nodiscard]] Precision precision() const { return precision_; }

    /// The processes that share the system. Most often there is one.
    [[nodiscard]] Ranks& ranks() const;
    /// The same without other processes: for systems that this one has to itself.
    [[nodiscard]] Execution alone() const;

    /// The threads, for the loops of execution/loops.hpp.
    [[nodiscard]] ThreadTeam& team() const { return *team_; }

  private:
    std::shared_ptr<ThreadTeam> team_;
    SimdLevel simd_;
    Precision precision_;
    std::shared_ptr<Ranks> ranks_;
};

}  // namespace ljmd
