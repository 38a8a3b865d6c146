#pragma once

#include "core/random.hpp"
#include "neighbors/cell_grid.hpp"
#include "observables/block_means.hpp"

namespace ljmd {

/// Excess chemical potential by Widom's insertion of a test particle at random positions in each configuration. With
/// psi its energy, tail included (2 u_tail for an additional atom),
///
///     mu_ex = -T ln <exp(-psi/T)>                                       at a temperature held by a thermostat
///     mu_ex = -<T> ln(<T^(3/2) exp(-psi/T)>/<T>^(3/2))                  at constant energy, T instantaneous
///
/// Few insertions dominate the mean: in a dense liquid one in 10^5 or fewer. A short run misses the most important
/// ones, and its standard error does not show that. There is no value in two cases:
///
/// - The error exceeds T/4: fewer than 16 insertions or configurations dominate the mean.
/// - The energy of the inserted particles exceeds an atom's by more than T. With the weights of the mean they are
///   equal, <psi exp(-psi/T)>/<exp(-psi/T)> = 2 <U>/N, because an inserted particle is an atom like the others (Shing
///   and Gubbins (1982), doi:10.1080/00268978200100841, compare the distributions). If psi is too high, insertions at
///   low energies are missing.
///
/// Test with log-normal weights (width of ln w from 1 to 3.5, 10 to 30000 insertions, 300 to 1500 trials each): the
/// remaining results have a mean deviation of at most 0.6 errors and a scatter of 0.5 to 1.15 errors about the true
/// value; without the second criterion, up to 8 errors.
///
/// In a film of liquid in its vapour it is the value of the whole box, mu - T ln(Lambda^3 N/V) with N/V of liquid and
/// vapour together, neither the liquid's nor the vapour's; a remark says so. Standard errors by block
/// averaging over configurations.
/// Observable: excess_chemical_potential [epsilon]. Sources: Widom (1963), doi:10.1063/1.1734110; Frenkel and Smit,
/// section 7.2.3
class WidomInsertion : public BlockMeans {
  public:
    /// @param insertions  number per configuration, at least 1
    /// @pre run.interaction is known
    WidomInsertion(const SampledRun& run, Index insertions, Every every);

    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;

  private:
    /// Means over the insertions into a configuration.
    struct Weights {
        double weight = 0.0;           ///< exp(-psi/T)
        double weighted_energy = 0.0;  ///< psi exp(-psi/T), without the tail
    };
    [[nodiscard]] Weights mean_weights(const State& state, double temperature);
    [[nodiscard]] bool tail_was_sampled(const Estimate& found) const;

    Interaction interaction_;
    std::optional<double> held_temperature_;
    bool is_film_;
    Random random_;
    Index insertions_;
    CellGrid grid_;
    GhostExchange ghosts_;
};

}  // namespace ljmd
