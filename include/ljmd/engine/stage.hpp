#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/observables/statistics/wanted_errors.hpp"
#include "ljmd/detail/options/table_description.hpp"
#include "ljmd/options/choice.hpp"

namespace ljmd {

/// Maximum number of steps of a stage, and of a resumed run.
inline constexpr Index max_steps = 1'000'000'000'000'000;

/// Steps of one integrator, with at most one thermostat and one barostat: one [[stage]] of a deck.
struct Stage {
    std::string name;  ///< for messages and results; unique in a run
    Choice integrator = {"velocity-verlet"};
    double time_step = 0.004;                ///< [tau]; a deck has to say it
    Index steps = 0;                         ///< with `until` the largest number of them
    std::optional<double> temperature = {};  ///< target of the thermostat [epsilon/k_B]; none: the start's
    bool sample = false;                     ///< whether observables are measured
    bool reverse = false;                    ///< whether the motion is reversed before the first step
    std::optional<Choice> thermostat = {};
    std::optional<Choice> barostat = {};  ///< for a fluid only
    std::uint64_t seed = 0;               ///< of the random numbers of thermostat and barostat

    /// (U + K)/N, tail and external energy included, to which velocities are scaled before the first step [epsilon];
    /// for a fluid only, and without a thermostat.
    std::optional<double> total_energy = {};

    /// Ends the last stage of a fluid, which is sampled, as soon as the averages of the run have these errors; see
    /// until_observables() and docs/averages.md.
    std::vector<WantedError> until = {};

    /// The keys of [[stage]] of a fluid, and of few bodies.
    void describe(TableDescription& description);
    void describe_few_body(TableDescription& description);

    friend bool operator==(const Stage&, const Stage&) = default;
};

/// The stage with all options of its plug-ins. @throws InputError for a plug-in or an option that is not known
[[nodiscard]] Stage completed(Stage stage);

/// The pressure that the barostat of a stage holds [epsilon/sigma^3]; none without a barostat.
[[nodiscard]] std::optional<double> held_pressure(const Stage& stage);

/// Whether a fluid conserves its total energy minus the heat from the thermostat in this stage, but for errors of the
/// integrator. True without a thermostat, and with a canonical one if there is no barostat.
[[nodiscard]] bool conserves_energy(const Stage& stage);

/// Steps of all stages; with `until` the largest number of them.
[[nodiscard]] Index total_steps(const std::vector<Stage>& stages);

/// Steps of the stages before the one with this index. @pre index <= stages.size()
[[nodiscard]] Index steps_before(const std::vector<Stage>& stages, std::size_t index);

/// Index of the first stage that is sampled; of the last stage if none is. @throws InputError without a stage
[[nodiscard]] std::size_t first_sampled(const std::vector<Stage>& stages);

}  // namespace ljmd
