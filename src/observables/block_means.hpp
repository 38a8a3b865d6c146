#pragma once

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// An analysis that follows from means over configurations: it keeps the block averages of some numbers of each, with
/// all covariances, and has no table. The numbers are made from energy and forces, so an evaluation has both.
class BlockMeans : public Analysis {
  public:
    [[nodiscard]] bool due(Index step) const final { return every_.due(step); }
    [[nodiscard]] bool needs_energy() const final { return true; }
    [[nodiscard]] Index samples() const final { return means_.samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const final { return {}; }
    void archive(Archive& a) final { a(means_); }

  protected:
    /// @param columns  numbers of each configuration, see the source of the analysis
    BlockMeans(Every every, Index columns) : means_(columns, Covariance::full), every_(every) {}

    BlockingAccumulator means_;

  private:
    Every every_;
};

}  // namespace ljmd
