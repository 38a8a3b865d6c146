#include "observables/structure/structure_factor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace ljmd {

namespace {

constexpr double max_points = 5e8;  // of 16 bytes each

double grid_points(const Box& box, double k_max) {
    constexpr double per_length = 1.5 / std::numbers::pi;  // see grid_density_modes
    return box.volume() * std::pow(per_length * k_max, 3);
}

struct StructureFactorOptions : AnalysisOptions {
    double k_max = 15.0;
    double width = 0.1;
    std::string method = "grid";
    Index every = 1000;

    void describe(Description& description) override {
        description.number("k_max", k_max).unit("1/sigma").above(0.0).at_most(1000.0).meaning("largest wave number");
        description.number("width", width)
            .unit("1/sigma")
            .at_least(1e-3)
            .at_most(10.0)
            .meaning("thickness of the shells of wave vectors that are averaged over");
        description.choice("method", {"direct", "grid"}, method)
            .meaning(
                "the density by a sum over atoms for each wave vector, or by a fast Fourier transform; the same to "
                "1e-10");
        description.integer("every", every)
            .at_least(1)
            .step_interval()
            .meaning("steps between configurations that are measured");
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        Misfits misfits;
        const double least = 2.0 * std::numbers::pi / run.box.edges().maxCoeff();
        if (k_max < least) {
            misfits.emplace_back("k_max", fmt::format("'k_max' in structure_factor is {:.6g}, but the smallest wave "
                                                      "number that the box allows is {:.6g}",
                                                      k_max, least));
        }
        const double points = grid_points(run.box, k_max);
        if (method == "grid" && points > max_points) {
            misfits.emplace_back("k_max",
                                 fmt::format("'k_max' in structure_factor is {:.6g}: its grid would have {:.2g} "
                                             "points, of at most {:.2g}; choose a smaller one, or method = \"direct\"",
                                             k_max, points, max_points));
        }
        return misfits;
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const auto how = method == "grid" ? StructureFactor::Method::grid : StructureFactor::Method::direct;
        return std::make_unique<StructureFactor>(run.box, k_max, width, how, Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_point = 16.0;  // of the grid: density, and half as many complex numbers
        constexpr double of_atom = 424.0;  // its weights on the grid, its place in the order of planes
        constexpr double of_power = 16.0;  // of exp(i k r), a complex number
        const auto shells = static_cast<Index>(k_max / width) + 1;
        const auto atoms = static_cast<double>(run.atoms);
        const double powers = (k_max * run.box.edges() / (2.0 * std::numbers::pi)).sum() + 3.0;
        return {.kept = BlockingAccumulator::bytes(shells, Covariance::diagonal, run.steps / every + 1),
                .fixed = method == "grid" ? of_point * grid_points(run.box, k_max) + of_atom * atoms
                                          : of_power * powers * atoms};
    }
};

}  // namespace

/// Structure factor, see structure_factor.hpp.
AnalysisMethod structure_factor() {
    return {.name = "structure_factor",
            .meaning = "structure factor S(k), written to sk.csv",
            .files = {"sk"},
            .follows_time = false,
            .quantities = {{"k", "k sigma", ""}, {"S", "S(k)", ""}},
            .charts = {{.file = "sk", .x = "k", .y = "S", .title = "Structure factor"}},
            .options = [] { return std::make_unique<StructureFactorOptions>(); }};
}

}  // namespace ljmd
