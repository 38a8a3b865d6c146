#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "ljmd/detail/deck/run_files.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "ljmd/detail/run/run_listener.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/engine/run_result.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// Options of a run with a directory, beside its specification.
struct DirectoryOptions {
    RunFiles files = {};                    ///< what it writes beside what every run does
    bool replace = false;                   ///< an earlier run in the directory; else it is refused
    Interruption interruption{};            ///< when to stop, with a checkpoint
    std::vector<Observer*> observers = {};  ///< measure in the sampled stages; they outlive the run
    RunListener* listener = nullptr;        ///< hears of stages, steps and warnings
};

/// Run a specification and write the directory that a deck's run writes (docs/files.md), with checkpoints. The
/// directory is created if it is missing, and locked while the run goes on. Results and files have the bits that a
/// Simulation and a deck that says the same give.
///
/// The record holds the specification as a deck, so `ljmd info`, `analyze`, `export` and `resume` know the run. A run
/// with observers, an external force or a formula of the program as its potential (PairPotential::custom) says so in
/// its record, and is resumed by resume_in_directory() alone; results of observers (Observer::average) are in
/// results.json. A configuration that the specification starts from is written to given-start.xyz.
/// @return the results; their warnings also have remarks on the start
/// @throws InputError       mistakes; a specification that no deck can tell, see deck_text(); a directory that cannot
/// be used, such as one with another run
/// @throws InUseError       another run is writing there
/// @throws Interrupted      the run was stopped as asked, and can be resumed
/// @throws PhysicsError, FileError, DataError, ThreadsError, and what an observer throws: the run can be resumed from
/// its last checkpoint, if it has one
RunResult run_in_directory(const FluidSpec& spec, const std::filesystem::path& directory,
                           const DirectoryOptions& options = {}, const Execution& execution = {});

/// Options of a run that is resumed.
struct ResumedDirectoryOptions {
    Index more_steps = 0;                         ///< added to the last stage, besides those added earlier
    int threads = 0;                              ///< their number; 0: as many as before
    Interruption interruption{};                  ///< as in DirectoryOptions
    std::optional<PairPotential> potential = {};  ///< the formula of the program that the run was begun with, if it was
    std::vector<Observer*> observers = {};        ///< as many as before, made alike, in the same order
    std::shared_ptr<ExternalForce> external = {};  ///< the one that it had before, see FluidSpec
    RunListener* listener = nullptr;
};

/// Resume a run of a fluid from the newest checkpoint in its directory, whether run_in_directory(),
/// resume_in_directory() or `ljmd run` began it. It ends as if it had not been interrupted, to the last bit. A run that
/// has come to its end writes its results anew and returns them.
/// @throws DataError        it is not the directory of a run
/// @throws CheckpointError  there is no checkpoint that can be used; the run was begun with other observers, another
/// external force or another formula as its potential
/// @throws as run_in_directory()
RunResult resume_in_directory(const std::filesystem::path& directory, const ResumedDirectoryOptions& options = {});

}  // namespace ljmd
