#include <fmt/format.h>

#include <algorithm>

#include "ljmd/observables/radial_distribution.hpp"

namespace ljmd {

namespace {

constexpr double usual_radius = 5.0;  // [sigma]: four shells of the liquid, and cheap in large systems

double largest_radius(const Box& box) {
    return 0.5 * box.shortest_edge();
}

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
            .keys = {Key::integer("bins")
                         .at_least(1)
                         .at_most(100000)
                         .defaults_to(std::int64_t{250})
                         .meaning("bins between 0 and `radius`"),
                     Key::number("radius")
                         .dimension(Dimension::length)
                         .unit("sigma")
                         .above(0.0)
                         .optional("5 sigma or L/2, whichever is smaller")
                         .meaning("largest distance, at most L/2"),
                     Key::integer("every")
                         .at_least(1)
                         .defaults_to(std::int64_t{200})
                         .meaning("steps between configurations that are counted")},
            .check =
                [](const Section& section, const SampledRun& run) {
                    std::vector<std::pair<std::string, std::string>> mistakes;
                    if (section.has("radius") && section.number("radius") > largest_radius(run.box)) {
                        mistakes.emplace_back("radius", fmt::format("'radius' in rdf is {}, but half the box is {}",
                                                                    section.number("radius"), largest_radius(run.box)));
                    }
                    return mistakes;
                },
            .make = [](const Section& section, const SampledRun& run) -> std::unique_ptr<Analysis> {
                const double radius =
                    section.has("radius") ? section.number("radius") : std::min(usual_radius, largest_radius(run.box));
                return std::make_unique<RadialDistribution>(section.integer("bins"), radius,
                                                            Every(section.integer("every")));
            }};
}

}  // namespace ljmd
