#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/compare/fluid.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// What a configuration sums up to, tail corrections left out.
struct Totals {
    double potential_energy;  ///< U [epsilon]
    double kinetic_energy;    ///< K [epsilon], of the velocities at the time of the positions
    double virial;            ///< W = sum over pairs of r . f [epsilon]
};

/// A configuration evaluated once.
struct PeerPoint {
    Totals totals;
    std::vector<Vec3> forces;  ///< on each atom [epsilon/sigma]
    /// Tail corrections, where the fluid has them and the program knows them: energy per atom [epsilon], pressure
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

/// A way in which the program integrates.
struct PeerMethod {
    std::string name;               ///< in the program's own terms
    std::vector<std::string> ours;  ///< integrators of ljmd with which it shares its positions, to rounding
};

/// An independent program that integrates the same fluid. It begins from the fluid's moment at every call.
class Peer {
  public:
    virtual ~Peer() = default;

    /// With version, and what else decides its numbers: "OpenMM 7.7 (Reference)".
    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual std::vector<PeerMethod> methods() const = 0;

    [[nodiscard]] virtual PeerPoint point() = 0;

    /// @param method  one of methods(), by name
    /// @param steps   at which a frame is wanted, ascending, from 0
    [[nodiscard]] virtual std::vector<PeerFrame> follow(const std::string& method, double time_step,
                                                        const std::vector<Index>& steps) = 0;

    /// What sampling calls for every row, and every `frame_every`-th step with the positions as well.
    using Visitor = std::function<void(Index step, const Totals& totals, const std::vector<Vec3>* positions)>;

    /// Integrate with the first of methods() and show what passes by, the start left out.
    /// @param every        steps between totals
    /// @param frame_every  steps between positions, a multiple of `every`; 0: none. They may be wrapped or not.
    virtual void sample(double time_step, Index steps, Index every, Index frame_every, const Visitor& visit) = 0;

    /// Wall time of that many steps [s] with nothing asked for in between, start-up left out.
    [[nodiscard]] virtual double seconds(double time_step, Index steps) = 0;

  protected:
    Peer() = default;
    Peer(const Peer&) = default;
    Peer& operator=(const Peer&) = default;
};

}  // namespace ljmd
