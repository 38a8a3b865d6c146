#pragma once

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// A film of liquid in its vapour, with two surfaces normal to an axis of the box.
///
///     gamma = (L/2) <p_N - p_T> = (L/2V) <W_zz - (W_xx + W_yy)/2>
///
/// is the tension of each surface, from the virial W_ab of all pairs. The motion is left out: its mean is the same in
/// all directions, and only its fluctuations would be added. Beside it the profiles of density and pressure across the
/// box, as pressure_profile() has them, in a frame in which the middle of the film rests at 0.
///
/// The density of the liquid is measured in the layers within half the half-thickness h of the film, the density of the
/// vapour in the outer half of what is left, |z| > (h + L/2)/2. The surfaces lie at +-h, where the mean profile has the
/// mean of its values in the middle and at the end of the box. Neither has a value where the two do not differ by more
/// than the larger one's half, or where half the liquid or the vapour is thinner than 2 sigma. Tension and pressure
/// have a value where both densities have one: a homogeneous fluid has no surface, and neither has a film seen along
/// another axis.
///
/// A plain cut exerts no impulse where pairs cross the cutoff; its forces, and so gamma, are the shifted potential's. A
/// tail correction is for homogeneous fluids: with one there is no value.
///
/// Standard errors by block averaging over the sampled configurations.
/// Table `film`: z (middle of the layer) [sigma], density, density_standard_error [sigma^-3], normal_pressure, its
/// error, tangential_pressure, its error [epsilon/sigma^3]. Observables: surface_tension [epsilon/sigma^2],
/// liquid_density, vapour_density [sigma^-3], normal_pressure (of the box; at equilibrium the vapour's).
/// Source: Kirkwood and Buff (1949), doi:10.1063/1.1747248; Allen and Tildesley, 2nd ed., sections 14.1 and 14.2
class Film : public Analysis {
  public:
    /// @param interaction  must have a potential
    /// @param axis         normal to the surfaces: 0, 1 or 2
    /// @param layers       across the box, an even number
    Film(const Interaction& interaction, const Box& box, Index axis, Index layers, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    [[nodiscard]] bool needs_energy() const override { return true; }
    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override { a(samples_, means_, densities_); }

    /// Memory of the averages of so many samples [bytes].
    [[nodiscard]] static double bytes(Index layers, Index samples);

  private:
    /// Mean density of the layers of the upper half in [first, last), counted from the middle.
    [[nodiscard]] Estimate mean_density(Index first, Index last) const;
    /// Where the surface lies, in layers from the middle; nothing where liquid and vapour cannot be told apart.
    [[nodiscard]] std::optional<double> surface() const;
    [[nodiscard]] double thickness() const { return edge_ / static_cast<double>(layers_); }

    PairPotential potential_;
    bool has_tail_;
    double edge_;
    Index axis_;
    Index layers_;
    Every every_;
    Index samples_ = 0;
    BlockingAccumulator means_;      ///< density, p_N, p_T of all layers, then gamma and p_N of the box
    BlockingAccumulator densities_;  ///< of the layers of both halves together, from the middle outwards
};

/// Atoms evaporate and condense slowly, and energies and the density of the liquid follow the number of atoms in it,
/// hidden below fast noise. So where the error of the vapour's density is a guess, so are theirs.
void mark_slow_exchange(std::vector<ObservableAverage>& averages);

}  // namespace ljmd
