#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/options/choice.hpp"

namespace ljmd {

/// Properties of the stage that a barostat needs.
struct PressureBath {
    double temperature;    ///< held by the thermostat of the stage [epsilon/k_B]
    double time_step;      ///< [tau]
    std::uint64_t seed;    ///< seed of random numbers
    double shortest_edge;  ///< shortest edge allowed [sigma]
};

/// The pressure of the pairs, tail included: without the part of the motion [epsilon/sigma^3].
struct VirialPressure {
    double mean;  ///< W/(3 V) + p_tail
    Vec3 along;   ///< W_aa/V + p_tail along each edge
};

/// Holds a pressure by changing the box and scaling the positions with it. It has no memory from one change to the
/// next.
class Barostat {
  public:
    virtual ~Barostat() = default;

    /// Whether it acts after this step of its stage, and so needs the pressure there.
    [[nodiscard]] virtual bool due(Index step_of_stage) const = 0;

    /// Act between two steps. If the box changes, forces become stale.
    /// @param pressure  of the state
    /// @throws PhysicsError if the pressure is too far from its target, or if the box becomes too small
    virtual void apply(State& state, const VirialPressure& pressure) const = 0;

  protected:
    Barostat() = default;
    Barostat(const Barostat&) = default;
    Barostat& operator=(const Barostat&) = default;
};

/// The options of a barostat, see Description.
class BarostatOptions {
  public:
    virtual ~BarostatOptions() = default;
    virtual void describe(Description& description) = 0;
    [[nodiscard]] virtual std::unique_ptr<Barostat> make(const PressureBath& bath) const = 0;

    /// The pressure to be held [epsilon/sigma^3].
    [[nodiscard]] virtual double held_pressure() const = 0;

    /// m in d(ln V)/dt = m (p - p_0), without noise [sigma^3/(epsilon tau)].
    [[nodiscard]] virtual double volume_mobility() const = 0;

  protected:
    BarostatOptions() = default;
    BarostatOptions(const BarostatOptions&) = default;
    BarostatOptions& operator=(const BarostatOptions&) = default;
};

/// A barostat, as decks select it. Each is one file in src/integrators/barostats.
struct BarostatMethod {
    std::string name;
    std::string meaning;
    bool changes_shape = false;                                 ///< changes the ratios of the edges
    std::function<std::unique_ptr<BarostatOptions>()> options;  ///< at their defaults
};

using ChosenBarostat = Chosen<BarostatMethod, BarostatOptions>;

/// All barostats, in alphabetical order.
[[nodiscard]] std::vector<BarostatMethod> all_barostats();

/// @throws InputError for an unknown name
[[nodiscard]] BarostatMethod find_barostat(const std::string& name);

/// The barostat of a choice with its options. @throws InputError see chosen()
[[nodiscard]] ChosenBarostat chosen_barostat(const Choice& choice);

}  // namespace ljmd
