#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/engine/stage.hpp"
#include "ljmd/input/placed.hpp"

namespace ljmd {

/// What a [[stage]] of both kinds of decks has.
struct StageTable {
    std::string name;
    ChosenIntegrator integrator = Stage().integrator;
    double time_step = 0.0;
    Index steps = 0;
    bool reverse = Stage().reverse;
    bool sample = Stage().sample;
};

/// `thermostat` in [[stage]].
struct ThermostatTable {
    ChosenThermostat method = {};

    void describe(TableDescription& description);
};

/// `barostat` in [[stage]].
struct BarostatTable {
    ChosenBarostat method = {};

    void describe(TableDescription& description);
};

/// `until` in [[stage]].
struct UntilTable {
    UntilTable();

    std::vector<std::optional<double>> errors;  ///< of each of until_observables()
    Index max_steps = 0;

    void describe(TableDescription& description);
};

/// [[stage]] of a fluid.
struct FluidStageTable : StageTable {
    std::optional<double> temperature;   ///< [epsilon/k_B]
    std::optional<double> total_energy;  ///< per atom [epsilon]
    std::optional<Placed<ThermostatTable>> thermostat;
    std::optional<Placed<BarostatTable>> barostat;
    std::optional<Placed<UntilTable>> until;  ///< in place of the number of steps

    [[nodiscard]] Index most_steps() const { return until ? until->max_steps : steps; }

    void describe(TableDescription& description);
};

/// [[stage]] of a few-body deck.
struct FewBodyStageTable : StageTable {
    FewBodyStageTable() { sample = true; }

    void describe(TableDescription& description);
};

}  // namespace ljmd
