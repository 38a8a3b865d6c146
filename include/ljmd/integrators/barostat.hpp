#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ljmd/core/description.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// What a barostat has to know of the stage in which it works.
struct PressureBath {
    double temperature;    ///< that the thermostat beside it holds [epsilon/k_B]
    double time_step;      ///< [tau]
    std::uint64_t seed;    ///< of random numbers
    double shortest_edge;  ///< that the box may have [sigma]
};

/// Changes the box, and the positions with it, to hold a pressure. Nothing is carried along from one time to the next.
class Barostat {
  public:
    virtual ~Barostat() = default;

    /// Whether it wants to act after this step of its stage, and so to know the pressure there.
    [[nodiscard]] virtual bool due(Index step_of_stage) const = 0;

    /// Act between two steps. Forces become stale when the box changes.
    /// @param virial_pressure  W/(3 V) of the state, tail included [epsilon/sigma^3]
    /// @throws PhysicsError when the pressure is too far from what is to be held, or the box becomes too small
    virtual void apply(State& state, double virial_pressure) const = 0;

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

  protected:
    BarostatOptions() = default;
    BarostatOptions(const BarostatOptions&) = default;
    BarostatOptions& operator=(const BarostatOptions&) = default;
};

/// A kind of barostat that decks can select. One file in src/integrators/barostats each.
struct BarostatMethod {
    std::string name;
    std::string meaning;
    std::function<std::unique_ptr<BarostatOptions>()> options;  ///< at their defaults
};

using ChosenBarostat = Chosen<BarostatMethod, BarostatOptions>;

/// Every barostat there is, in alphabetical order.
[[nodiscard]] std::vector<BarostatMethod> all_barostats();

/// @throws InputError for an unknown name
[[nodiscard]] BarostatMethod find_barostat(const std::string& name);

}  // namespace ljmd
