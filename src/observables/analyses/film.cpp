#include "observables/interface/film.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ljmd {

namespace {

const std::vector<std::string>& axes() {
    static const std::vector<std::string> names{"x", "y", "z"};
    return names;
}

struct FilmOptions : AnalysisOptions {
    std::string axis = "z";
    Index layers = 200;
    Index every = 50;

    void describe(Description& description) override {
        description.choice("axis", axes(), axis).meaning("edge of the box that is normal to the surfaces");
        description.integer("layers", layers)
            .at_least(2)
            .at_most(1000)
            .meaning("number of layers that the box is divided into for the profiles; even");
        description.integer("every", every)
            .at_least(1)
            .step_interval()
            .meaning("steps between configurations that are measured");
    }
    [[nodiscard]] Misfits check(const SampledRun& /*run*/) const override {
        if (layers % 2 != 0) {
            return {{"layers", fmt::format("'layers' in film is {}, it must be even", layers)}};
        }
        return {};
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const auto number = std::find(axes().begin(), axes().end(), axis) - axes().begin();
        return std::make_unique<Film>(run.interaction.value(), run.box, static_cast<Index>(number), layers,
                                      Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_atom = 120.0;  // of a copy of the positions with its images and cells
        constexpr double blocks = 64.0;
        return {.kept = Film::bytes(layers, run.steps / every + 1),
                .passing = of_atom * static_cast<double>(run.atoms) + 16.0 * blocks * static_cast<double>(layers)};
    }
};

}  // namespace

/// Film of liquid in its vapour, see film.hpp.
AnalysisMethod film() {
    return {.name = "film",
            .meaning =
                "surface tension of a film of liquid in its vapour, with the profiles of density and pressure across "
                "the box, written to film.csv",
            .files = {"film"},
            .follows_time = false,
            .needs = {.velocities = true, .interaction = true},
            .quantities = {{"surface_tension", "gamma", "epsilon/sigma^2"},
                           {"normal_pressure", "p_N", "epsilon/sigma^3"},
                           {"tangential_pressure", "p_T", "epsilon/sigma^3"},
                           {"liquid_density", "rho_l", "sigma^-3"},
                           {"vapour_density", "rho_v", "sigma^-3"},
                           {"z", "z", "sigma"}},
            .charts = {{.file = "film", .x = "z", .y = "density", .title = "Density across the film", .lead = true},
                       {.file = "film", .x = "z", .y = "normal_pressure", .title = "Normal pressure across the film"},
                       {.file = "film",
                        .x = "z",
                        .y = "tangential_pressure",
                        .title = "Tangential pressure across the film",
                        .level = 0.0,
                        .level_label = "no pressure"}},
            .options = [] { return std::make_unique<FilmOptions>(); }};
}

}  // namespace ljmd
