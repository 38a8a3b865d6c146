#pragma once

#include <optional>
#include <vector>

#include "ljmd/detail/observables/statistics/run_averages.hpp"

namespace ljmd {

/// Fluctuations of the energies over the frames of a trajectory.
class EnergyFluctuations {
  public:
    void add(const Thermodynamics& frame);

    /// Standard deviation of the total energy over the standard deviation of the kinetic energy: close to 0 at constant
    /// energy, about 1 or more in the canonical ensemble, where kinetic and potential energy fluctuate independently.
    /// Nothing if the kinetic energy does not fluctuate.
    [[nodiscard]] std::optional<double> total_over_kinetic() const;

  private:
    /// Sums of Welford's algorithm.
    struct Series {
        double mean = 0.0;
        double squares = 0.0;  ///< sum of squared deviations from the mean
    };
    static void add_to(Series& series, double value, double count);

    double count_ = 0.0;
    Series total_;
    Series kinetic_;
};

/// Statements of the deck about the frames that the frames can contradict.
struct DeckClaims {
    Ensemble ensemble = Ensemble::none;
    std::optional<double> held_temperature = {};
};

/// Withdraw values that rely on a statement of the deck if the frames contradict it; each gets a remark instead:
///
/// - the heat capacity and other response functions, if the box of the frames changes at "constant volume" or does not
///   at "constant pressure", if the total energy fluctuates at "constant energy", or if it does not in the "canonical"
///   ensemble;
/// - the excess chemical potential, if the temperature of the frames differs from the temperature of the deck's
///   thermostat by more than 5 standard errors and more than 5 %.
///
/// @param box_changes  the first frame, from 1, whose box differs from frame 1's
void withdraw_contradicted(std::vector<ObservableAverage>& averages, const DeckClaims& deck,
                           const EnergyFluctuations& energies, std::optional<Index> box_changes);

}  // namespace ljmd
