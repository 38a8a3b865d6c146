#include <fmt/format.h>

#include <algorithm>

#include "observables/cutoff_correction.hpp"

namespace ljmd {

namespace {

constexpr double default_cutoff_radius = 5.0;  // [sigma]: affordable in large systems

struct CutoffCorrectionOptions : AnalysisOptions {
    std::optional<double> radius;
    Index every = 200;

    void describe(Description& description) override {
        description.number("radius", radius)
            .dimension(Dimension::length)
            .unit("sigma")
            .above(0.0)
            .optional("5 sigma or L/2, whichever is smaller")
            .meaning("pairs up to this distance are taken as they are, what is beyond with g = 1; at most L/2");
        description.integer("every", every).at_least(1).step_interval().meaning("steps between configurations");
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        const double most = 0.5 * run.box.shortest_edge();
        if (radius && run.interaction && *radius < run.interaction->potential.cutoff().radius) {
            return {{"radius", fmt::format("'radius' in cutoff_correction is {}, within the cutoff of {}", *radius,
                                           run.interaction->potential.cutoff().radius)}};
        }
        if (radius && *radius > most) {
            return {
                {"radius", fmt::format("'radius' in cutoff_correction is {}, but half the box is {}", *radius, most)}};
        }
        return {};
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        return std::make_unique<CutoffCorrection>(
            run, std::max(radius_in(run.box), run.interaction.value().potential.cutoff().radius), Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_copy = 2000.0;  // of an atom in the sorted copy, with its images of half a box
        return {.kept = BlockingAccumulator::bytes(CutoffCorrection::columns, Covariance::full, run.steps / every + 1),
                .passing = of_copy * static_cast<double>(run.atoms)};
    }

  private:
    [[nodiscard]] double radius_in(const Box& box) const {
        return radius.value_or(std::min(default_cutoff_radius, 0.5 * box.shortest_edge()));
    }
};

}  // namespace

/// What the cutoff does to energy and pressure, see cutoff_correction.hpp.
AnalysisMethod cutoff_correction() {
    return {.name = "cutoff_correction",
            .meaning = "what to add to energy and pressure for those of the potential without cutoff",
            .files = {},
            .follows_time = false,
            .needs = {.interaction = true, .homogeneous = true},
            .quantities = {{"cutoff_energy", "du_c", "epsilon"},
                           {"cutoff_pressure", "dp_c", "epsilon/sigma^3"},
                           {"cutoff_energy_response", "du_r", "epsilon"},
                           {"cutoff_pressure_response", "dp_r", "epsilon/sigma^3"}},
            .options = [] { return std::make_unique<CutoffCorrectionOptions>(); }};
}

}  // namespace ljmd
