#include <fmt/format.h>

#include <algorithm>

#include "ljmd/observables/structure/radial_distribution.hpp"

namespace ljmd {

namespace {

constexpr double usual_radius = 5.0;  // [sigma]: four shells of the liquid, and affordable in large systems

double largest_radius(const Box& box) {
    return 0.5 * box.shortest_edge();
}

double radius_of(const Section& section, const SampledRun& run) {
    return section.has("radius") ? section.number("radius") : std::min(usual_radius, largest_radius(run.box));
}

AnalysisSize size_of(const Section& section, const SampledRun& run) {
    constexpr double of_atom = 36.0;   // pair histogram: position, cell, bins found by one thread
    constexpr double of_part = 512.0;  // one counter in each block of atoms
    const Index bins = section.integer("bins");
    const Index samples = run.steps / section.integer("every") + 1;
    const CoordinationNumber::Division division = CoordinationNumber::division(bins, radius_of(section, run));
    return {.kept = BlockingAccumulator::bytes(3 * bins, Covariance::diagonal, samples) +
                    BlockingAccumulator::bytes(division.shells, Covariance::full, samples),
            .passing = of_atom * static_cast<double>(run.atoms) + of_part * static_cast<double>(bins * division.parts)};
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
                return std::make_unique<RadialDistribution>(section.integer("bins"), radius_of(section, run),
                                                            Every(section.integer("every")));
            },
            .size = size_of};
}

}  // namespace ljmd
