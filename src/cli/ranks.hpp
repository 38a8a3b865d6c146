#pragma once

#include <functional>
#include <memory>
#include <string>

#include "deck/checked_run.hpp"
#include "execution/ranks.hpp"
#include "io/files/program_module.hpp"
#include "run/held_run.hpp"

namespace ljmd {

/// The part of the program for MPI.
[[nodiscard]] ProgramModule mpi_module();

/// Join the ranks that mpirun, mpiexec or srun has started, if it has started more than one.
/// @return null without a launcher, and if it has started one process alone
/// @throws InputError if several were started and the module is not there, or does not fit the launcher
[[nodiscard]] std::shared_ptr<Ranks> launched_ranks(const ProgramModule& mpi);

/// The ranks that share the run of this process; null: it runs alone. The same ones at every call.
/// @throws InputError as launched_ranks()
[[nodiscard]] std::shared_ptr<Ranks> shared_ranks();

/// Refuse a command that shares no work where mpirun has started several processes. @throws InputError
void refuse_ranks(const std::string& command);

/// Do what each rank does by itself before the work is shared. If it fails at one of them, all end, and one says why.
/// @param ranks  null: this process alone
/// @throws what `work` throws; RankLost if another rank says why
void prepare_together(const std::shared_ptr<Ranks>& ranks, const std::function<void()>& work);

/// The name of the SIMD level with which all ranks compute, see agreed_level(). Rank 0 warns if a rank by itself would
/// take another one. Collective.
/// @param ranks  null: this process alone, which takes what is named
/// @param named  on the command line; empty: nothing
/// @throws InputError, at one rank; RankLost elsewhere
[[nodiscard]] std::string agreed_simd(const std::shared_ptr<Ranks>& ranks, const std::string& named);

/// Require that all ranks have read the same deck and the same start file, and that ranks can share the run.
/// Collective.
/// @throws InputError, at rank 0; RankLost elsewhere
void require_shareable(const std::shared_ptr<Ranks>& ranks, const Deck& deck, const CheckedRun& run);

/// The same for a run that is resumed: its deck and its checkpoint.
void require_shareable(const std::shared_ptr<Ranks>& ranks, const HeldRun& run);

/// Report the exception that is being handled, and end this rank: by an exit code, if all ranks end because of it; else
/// it ends all of them. What all ranks find, rank 0 says. Without other ranks: report_current_exception().
/// @return the exit code
[[nodiscard]] int end_after_exception();

}  // namespace ljmd
