#include "observables/response/sampled_responses.hpp"

namespace ljmd {

namespace {

struct ResponseFunctionsOptions : AnalysisOptions {
    Index every = 50;

    void describe(Description& description) override {
        description.integer("every", every).at_least(1).step_interval().meaning("steps between configurations");
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        return std::make_unique<SampledResponses>(run, Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_copy = 230.0;  // of an atom in the sorted copy, with images
        return {.kept = ResponseFunctions::bytes(run.steps / every + 1),
                .passing = of_copy * static_cast<double>(run.atoms)};
    }
};

}  // namespace

/// Response functions, see response_functions.hpp and sampled_responses.hpp.
AnalysisMethod response_functions() {
    return {.name = "response_functions",
            .meaning =
                "compressibility, thermal expansion, c_p, speed of sound and others from fluctuations, in every "
                "ensemble",
            .files = {},
            .follows_time = false,
            .needs = {.velocities = true, .interaction = true, .fixed_box = false, .homogeneous = true},
            .quantities = {{"heat_capacity_cp", "c_p", "k_B"},
                           {"isothermal_compressibility", "kappa_T", "sigma^3/epsilon"},
                           {"adiabatic_compressibility", "kappa_S", "sigma^3/epsilon"},
                           {"thermal_expansion", "alpha_p", "k_B/epsilon"},
                           {"thermal_pressure_coefficient", "gamma_V", "k_B/sigma^3"},
                           {"speed_of_sound", "w", "sigma/tau"},
                           {"joule_thomson_coefficient", "mu_JT", "sigma^3/k_B"}},
            .options = [] { return std::make_unique<ResponseFunctionsOptions>(); }};
}

}  // namespace ljmd
