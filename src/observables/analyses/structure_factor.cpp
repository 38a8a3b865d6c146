#include "ljmd/observables/structure/structure_factor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace ljmd {

namespace {

constexpr double most_points = 5e8;  // of 16 bytes each

double grid_points(const Box& box, double k_max) {
    constexpr double per_length = 1.5 / std::numbers::pi;  // see grid_density_modes
    return box.volume() * std::pow(per_length * k_max, 3);
}

AnalysisSize size_of(const Section& section, const SampledRun& run) {
    constexpr double of_point = 16.0;  // grid: density, and half as many complex numbers
    constexpr double of_atom = 424.0;  // its weights on the grid, and its index in the order of planes
    constexpr double of_power = 16.0;  // power of exp(i k r), a complex number
    const double k_max = section.number("k_max");
    const auto shells = static_cast<Index>(k_max / section.number("width")) + 1;
    const auto atoms = static_cast<double>(run.atoms);
    const double powers = (k_max * run.box.edges() / (2.0 * std::numbers::pi)).sum() + 3.0;
    return {.kept = BlockingAccumulator::bytes(shells, Covariance::diagonal, run.steps / section.integer("every") + 1),
            .fixed = section.text("method") == "grid" ? of_point * grid_points(run.box, k_max) + of_atom * atoms
                                                      : of_power * powers * atoms};
}

}  // namespace

/// Structure factor, see structure_factor.hpp.
AnalysisMethod structure_factor() {
    return {.name = "structure_factor",
            .meaning = "structure factor S(k), written to sk.csv",
            .files = {"sk"},
            .follows_time = false,
            .keys = {Key::number("k_max").unit("1/sigma").above(0.0).at_most(1000.0).defaults_to(15.0).meaning(
                         "largest wave number"),
                     Key::number("width").unit("1/sigma").at_least(1e-3).at_most(10.0).defaults_to(0.1).meaning(
                         "thickness of the shells of wave vectors that are averaged over"),
                     Key::choice("method", {"direct", "grid"})
                         .defaults_to("grid")
                         .meaning("the density by a sum over atoms for each wave vector, or by a fast Fourier "
                                  "transform; the same to 1e-10"),
                     Key::integer("every")
                         .at_least(1)
                         .defaults_to(std::int64_t{1000})
                         .meaning("steps between configurations that are measured")},
            .check =
                [](const Section& section, const SampledRun& run) {
                    std::vector<std::pair<std::string, std::string>> mistakes;
                    const double least = 2.0 * std::numbers::pi / run.box.edges().maxCoeff();
                    if (section.number("k_max") < least) {
                        mistakes.emplace_back("k_max", fmt::format("'k_max' in structure_factor is {:.6g}, but the "
                                                                   "smallest wave number that the box allows is {:.6g}",
                                                                   section.number("k_max"), least));
                    }
                    const double points = grid_points(run.box, section.number("k_max"));
                    if (section.text("method") == "grid" && points > most_points) {
                        mistakes.emplace_back(
                            "k_max",
                            fmt::format("'k_max' in structure_factor is {:.6g}: its grid would have {:.2g} "
                                        "points, of at most {:.2g}; choose a smaller one, or method = \"direct\"",
                                        section.number("k_max"), points, most_points));
                    }
                    return mistakes;
                },
            .make = [](const Section& section, const SampledRun& run) -> std::unique_ptr<Analysis> {
                const auto method =
                    section.text("method") == "grid" ? StructureFactor::Method::grid : StructureFactor::Method::direct;
                return std::make_unique<StructureFactor>(run.box, section.number("k_max"), section.number("width"),
                                                         method, Every(section.integer("every")));
            },
            .size = size_of};
}

}  // namespace ljmd
