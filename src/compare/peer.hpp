#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/fluid.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Totals of a configuration, without tail corrections.
struct Totals {
    double potential_energy;  ///< U [epsilon]
    double kinetic_energy;    ///< K [epsilon], from velocities at the time of the positions
    double virial;            ///< W = sum over pairs of r . f [epsilon]
};

/// A configuration evaluated once.
struct PeerPoint {
    Totals totals;
    std::vector<Vec3> forces;  ///< on each atom [epsilon/sigma]
    /// Tail corrections, if the fluid has them and the program supports them: energy per atom [epsilon], pressure
    /// [epsilon/sigma^3].
    std::optional<double> tail_energy{};
    std::optional<double> tail_pressure{};
};

/// One step of a trajectory.
struct PeerFrame {
    Index step;  ///< since the fluid's moment
    double potential_energy;
    double kinetic_energy;        ///< at the time of the positions
    std::vector<Vec3> positions;  ///< unwrapped [sigma]
};

/// An integration method of a program.
struct PeerMethod {
    std::string name;               ///< in the program's own terms
    std::vector<std::string> ours;  ///< integrators of ljmd with the same positions, up to rounding
};

/// Another program that integrates the same fluid. Every call starts from the fluid's moment.
class Peer {
  public:
    virtual ~Peer() = default;

    /// Name with version and other settings that affect the numbers: "OpenMM 7.7 (Reference)".
    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual std::vector<PeerMethod> methods() const = 0;

    [[nodiscard]] virtual PeerPoint point() = 0;

    /// @param method  one of methods(), by name
    /// @param steps   steps of the frames, ascending, from 0
    [[nodiscard]] virtual std::vector<PeerFrame> follow(const std::string& method, double time_step,
                                                        const std::vector<Index>& steps) = 0;

    /// Called by sample() for every row; every `frame_every`-th step also has the positions.
    using Visitor = std::function<void(Index step, const Totals& totals, const std::vector<Vec3>* positions)>;

    /// Integrate with the first of methods() and visit the samples, without the start.
    /// @param every        steps between totals
    /// @param frame_every  steps between positions, a multiple of `every`; 0: none. Positions may be wrapped or not.
    virtual void sample(double time_step, Index steps, Index every, Index frame_every, const Visitor& visit) = 0;

    /// Wall time of this many steps [s] without output, start-up excluded.
    [[nodiscard]] virtual double seconds(double time_step, Index steps) = 0;

  protected:
    Peer() = default;
    Peer(const Peer&) = default;
    Peer& operator=(const Peer&) = default;
};

}  // namespace ljmd
