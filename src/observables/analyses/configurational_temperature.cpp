#include "observables/configurational_temperature.hpp"

namespace ljmd {

namespace {

struct ConfigurationalTemperatureOptions : AnalysisOptions {
    Index every = 100;

    void describe(Description& description) override {
        description.integer("every", every).at_least(1).step_interval().meaning("steps between configurations");
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        return std::make_unique<ConfigurationalTemperature>(run, Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_copy = 230.0;  // of an atom in the sorted copy, with images
        return {.kept = BlockingAccumulator::bytes(2, Covariance::full, run.steps / every + 1),
                .passing = of_copy * static_cast<double>(run.atoms)};
    }
};

}  // namespace

/// Configurational temperature, see configurational_temperature.hpp.
AnalysisMethod configurational_temperature() {
    return {.name = "configurational_temperature",
            .meaning = "temperature from forces and the curvature of the potential, without velocities",
            .files = {},
            .follows_time = false,
            .needs = {.interaction = true, .fixed_box = false},
            .quantities = {{"configurational_temperature", "T_conf", "epsilon/k_B"}},
            .options = [] { return std::make_unique<ConfigurationalTemperatureOptions>(); }};
}

}  // namespace ljmd
