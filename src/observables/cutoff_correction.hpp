#pragma once

#include "observables/block_means.hpp"

namespace ljmd {

/// What the cutoff of a run does to energy and pressure: the numbers to add to its averages for the formula without
/// truncation.
///
/// U_R is the energy of a configuration by the formula, with all pairs up to a radius R, at most half the box, and with
/// tail corrections for g = 1 beyond it; U that by which the atoms move, with the tail correction of the run. With
/// D = U_R - U the averages in the ensemble of U_R are to first order in D, for energy per atom and pressure alike,
///
///     <A_R>_R = <A> + <A_R - A> - (<A_R D> - <A_R> <D>)/T
///
/// The second term is what the pairs that were left out add, the third how the structure responds to them. In a liquid
/// the third is small, because its density hardly fluctuates; near the critical point it is the larger one. What is
/// beyond R acts as if g were 1 there.
///
/// Observables: cutoff_energy [epsilon] and cutoff_pressure [epsilon/sigma^3], the sums of both terms;
/// cutoff_energy_response and cutoff_pressure_response, the third terms alone. Errors by block averages with all
/// covariances. Without a thermostat that holds T, or with a barostat, they have no value.
/// Source: the perturbation theory of Zwanzig (1954), doi:10.1063/1.1740409, to first order
class CutoffCorrection : public BlockMeans {
  public:
    /// @param radius  R [sigma], above 0 and at most half the shortest edge of the box
    /// @pre run.interaction is known
    CutoffCorrection(const SampledRun& run, double radius, Every every);

    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;

    static constexpr Index columns = 6;  ///< components of the means, see the source

  private:
    Interaction interaction_;
    TailCorrection beyond_;  ///< of the formula beyond R
    double radius_;
    double atoms_;
    std::optional<double> temperature_;  ///< that is held; empty in another ensemble
};

}  // namespace ljmd
