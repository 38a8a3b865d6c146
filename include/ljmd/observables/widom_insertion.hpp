#pragma once

#include "ljmd/core/random.hpp"
#include "ljmd/core/schedule.hpp"
#include "ljmd/neighbors/cell_grid.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/blocking.hpp"

namespace ljmd {

/// Excess chemical potential by insertion of a test particle at random places of each configuration. With psi its
/// energy, tail included (2 u_tail for one atom more),
///
///     mu_ex = -T ln <exp(-psi/T)>                                       at a temperature that is held
///     mu_ex = -<T> ln(<T^(3/2) exp(-psi/T)>/<T>^(3/2))                  at constant energy, T that of the moment
///
/// The mean is that of a few lucky places: in a dense liquid one of 10^5 or fewer counts, and errors are known only
/// when many of these were met. Standard errors by blocking over configurations. Observable: excess_chemical_potential
/// [epsilon]. Sources: Widom (1963), doi:10.1063/1.1734110; Frenkel and Smit, section 7.2.3
class WidomInsertion : public Analysis {
  public:
    /// @param insertions  places in each configuration, at least 1
    /// @pre run.interaction is known
    WidomInsertion(const SampledRun& run, Index insertions, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] Index samples() const override { return means_.samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const override { return {}; }
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(means_); }

  private:
    /// Mean of exp(-psi/T) over the places of a configuration.
    [[nodiscard]] double mean_weight(const State& state, double temperature);

    Interaction interaction_;
    std::optional<double> held_temperature_;
    Random random_;
    Index insertions_;
    Every every_;
    CellGrid grid_;
    GhostExchange ghosts_;
    BlockingAccumulator means_;  ///< T^(3/2) exp(-psi/T), T; exp(-psi/T), T where T is held
};

}  // namespace ljmd
