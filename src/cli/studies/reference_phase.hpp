#pragma once

#include <filesystem>
#include <string>

#include "deck/deck.hpp"
#include "io/files/directory_lock.hpp"
#include "study/reference/reference_values.hpp"
#include "study/sweep_record.hpp"

namespace ljmd {

/// How replicas are run.
struct ReplicaOptions {
    int jobs = 0;  ///< at a time; 0: the number of processors
    bool force = false;
    bool quiet = false;
};

/// Replicas of one deck in a folder of their own, which can be made longer.
class ReferencePhase {
  public:
    /// @param name   of the folder
    /// @param out    where it is
    /// @param deck   text
    /// @param first  steps of the sampled stage in the deck
    ReferencePhase(std::string name, const std::filesystem::path& out, const std::string& deck, Index first,
                   Index replicas, const ReplicaOptions& options);

    /// Run until all replicas have their lengths.
    void complete();

    /// Give all replicas so many steps in their sampled stages, and run them.
    void lengthen(Index steps);

    [[nodiscard]] Index steps() const { return first_ + plan_.steps_added; }

    [[nodiscard]] ReplicaFolder folder() const;

  private:
    std::string name_;
    Index first_;
    ReplicaOptions options_;
    DirectoryLock lock_;
    Deck deck_;
    SweepPlan plan_;
};

}  // namespace ljmd
