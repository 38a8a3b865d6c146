#include <fmt/format.h>

#include <algorithm>

#include "observables/structure/radial_distribution.hpp"

namespace ljmd {

namespace {

constexpr double default_radius = 5.0;  // [sigma]: four shells of the liquid, and affordable in large systems

/// Of half the box that a barostat makes smaller and larger.
constexpr double share_of_changing_box = 0.9;

double largest_radius(const Box& box) {
    return 0.5 * box.shortest_edge();
}

struct RdfOptions : AnalysisOptions {
    Index bins = 250;
    std::optional<double> radius = {};
    Index every = 200;

    void describe(Description& description) override {
        description.integer("bins", bins).at_least(1).at_most(100000).meaning("bins between 0 and `radius`");
        description.number("radius", radius)
            .dimension(Dimension::length)
            .unit("sigma")
            .above(0.0)
            .optional("5 sigma or L/2, with a barostat 0.45 L, whichever is smaller")
            .meaning("largest distance, at most L/2");
        description.integer("every", every)
            .at_least(1)
            .step_interval()
            .meaning("steps between configurations that are counted");
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        if (radius && *radius > largest_radius(run.box)) {
            return {{"radius",
                     fmt::format("'radius' in rdf is {}, but half the box is {}", *radius, largest_radius(run.box))}};
        }
        return {};
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        return std::make_unique<RadialDistribution>(bins, radius_in(run), Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_atom = 36.0;   // of a pair histogram: place, cell, what one thread finds
        constexpr double of_part = 512.0;  // a counter in each block of atoms
        const Index samples = run.steps / every + 1;
        const CoordinationNumber::Division division = CoordinationNumber::division(bins, radius_in(run));
        return {
            .kept = BlockingAccumulator::bytes(3 * bins, Covariance::diagonal, samples) +
                    BlockingAccumulator::bytes(division.shells, Covariance::full, samples),
            .passing = of_atom * static_cast<double>(run.atoms) + of_part * static_cast<double>(bins * division.parts)};
    }

  private:
    [[nodiscard]] double radius_in(const SampledRun& run) const {
        const double share = run.held_pressure ? share_of_changing_box : 1.0;
        return radius.value_or(std::min(default_radius, share * largest_radius(run.box)));
    }
};

}  // namespace

/// Radial distribution function, see radial_distribution.hpp.
AnalysisMethod rdf() {
    return {.name = "rdf",
            .meaning =
                "radial distribution function g(r), written to rdf.csv, and the structure factor that follows from "
                "it, to sk_from_rdf.csv",
            .files = {"rdf", "sk_from_rdf"},
            .follows_time = false,
            .needs = {.fixed_box = false},
            .quantities = {{"r", "r", "sigma"},
                           {"g", "g(r)", ""},
                           {"coordination_number", "n_c", ""},
                           {"k", "k sigma", ""},
                           {"S", "S(k)", ""}},
            .charts = {{.file = "rdf",
                        .x = "r",
                        .y = "g",
                        .title = "Radial distribution function",
                        .lead = true,
                        .level = 1.0,
                        .level_label = "no order"},
                       {.file = "sk_from_rdf",
                        .x = "k",
                        .y = "S",
                        .title = "Structure factor from g(r)",
                        .caption = "The band is one standard error. Ripples before the first peak come from the "
                                   "end of g(r) and are not in it; the analysis structure_factor has none."}},
            .options = [] { return std::make_unique<RdfOptions>(); }};
}

}  // namespace ljmd
