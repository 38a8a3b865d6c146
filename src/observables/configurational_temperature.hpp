#pragma once

#include "observables/block_means.hpp"

namespace ljmd {

/// Temperature of the configurations, which needs no velocities:
///
///     T_conf = <sum over atoms of f^2>/<sum over atoms of lap_i U>
///
/// In the canonical ensemble it is the temperature, exactly and for any number of atoms (integrate div grad exp(-U/T)
/// by parts); at constant energy except for terms of order 1/N. A difference from the kinetic temperature tells of a
/// time step that is too long (velocity Verlet: by the fraction that TimeStepError gives), of a system that is not in
/// equilibrium, or of wrong forces. The Laplacian is taken from PairCurvature, with the term of a force that jumps at
/// the cutoff.
///
/// Observable: configurational_temperature [epsilon/k_B]. Error by block averaging, as of a ratio of two means.
/// Sources: Rugh (1997), doi:10.1103/PhysRevLett.78.772; Butler, Ayton, Jepps and Evans (1998), doi:10.1063/1.477301;
/// Jepps, Ayton and Evans (2000), doi:10.1103/PhysRevE.62.4757
class ConfigurationalTemperature : public BlockMeans {
  public:
    /// @pre run.interaction is known
    ConfigurationalTemperature(const SampledRun& run, Every every);

    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;

  private:
    Interaction interaction_;
};

}  // namespace ljmd
