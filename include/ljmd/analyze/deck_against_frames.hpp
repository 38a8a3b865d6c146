#pragma once

#include <optional>
#include <vector>

#include "ljmd/observables/statistics/run_averages.hpp"

namespace ljmd {

/// How energies fluctuate over the frames of a trajectory.
class EnergyFluctuations {
  public:
    void add(const Thermodynamics& frame);

    /// Standard deviation of the total energy over that of the kinetic energy: next to 0 where energy is constant, at
    /// least about 1 in the canonical ensemble, where both parts fluctuate on their own. Nothing where the kinetic
    /// energy does not fluctuate.
    [[nodiscard]] std::optional<double> total_over_kinetic() const;

  private:
    /// Welford's sums.
    struct Series {
        double mean = 0.0;
        double squares = 0.0;  ///< of the deviations from the mean
    };
    static void add_to(Series& series, double value, double count);

    double count_ = 0.0;
    Series total_;
    Series kinetic_;
};

/// What the deck says of the frames that it is used for, and the frames can contradict.
struct DeckClaims {
    Ensemble ensemble = Ensemble::none;
    std::optional<double> held_temperature = {};
};

/// Take back the values that follow from what the deck says and the frames contradict; each gets a remark instead:
///
/// - the heat capacity, where the box of the frames changes, the total energy fluctuates at "constant energy", or does
///   not in the "canonical" ensemble;
/// - the excess chemical potential, where the frames have another temperature than the thermostat of the deck holds:
///   by more than 5 standard errors, and 5 %.
///
/// @param box_changes  the frame, from 1, whose box is another one than that of frame 1
void take_back_contradicted(std::vector<ObservableAverage>& averages, const DeckClaims& deck,
                            const EnergyFluctuations& energies, std::optional<Index> box_changes);

}  // namespace ljmd
