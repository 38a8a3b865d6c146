#include <fmt/format.h>

#include "observables/structure/crystal_order.hpp"

namespace ljmd {

namespace {

struct CrystalOptions : AnalysisOptions {
    std::string lattice = "fcc";
    std::optional<Index> cells = {};
    std::optional<Index> layers = {};
    Index families = 6;
    Index every = 50;

    void describe(Description& description) override {
        description.choice("lattice", lattice_names(), lattice).meaning("the lattice of cubic cells");
        description.integer("cells", cells)
            .at_least(1)
            .at_most(1024)
            .optional("those of a cube that holds all atoms")
            .meaning("cells along x and along y that fill the box");
        description.integer("layers", layers)
            .at_least(1)
            .at_most(1024)
            .optional("as many as `cells`")
            .meaning("cells along z that fill the box");
        description.integer("families", families)
            .at_least(1)
            .at_most(40)
            .meaning("sets of equivalent reciprocal lattice vectors whose Bragg peaks are measured, shortest first");
        description.integer("every", every)
            .at_least(1)
            .step_interval()
            .meaning("steps between configurations that are measured");
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        if (cells) {
            return {};
        }
        if (layers) {
            return {{"layers", "'layers' in crystal is of no use without 'cells'"}};
        }
        const NearestCells nearest = nearest_cells(find_lattice(lattice), run.atoms);
        if (nearest.below != nearest.above) {
            return {{"lattice", fmt::format("'cells' is missing in crystal: {} atoms do not fill a cube of {} cells; "
                                            "nearest are {} cells along an edge",
                                            run.atoms, lattice, nearest.below)}};
        }
        return {};
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const Lattice of = find_lattice(lattice);
        const Index along = cells.value_or(nearest_cells(of, run.atoms).below);
        return std::make_unique<CrystalOrder>(CrystalInBox{of, along, layers.value_or(along)}, families, Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_atom = 72.0;  // its displacement, its site, the sites that are taken
        return {.kept = CrystalOrder::bytes(families, run.steps / every + 1),
                .passing = of_atom * static_cast<double>(run.atoms)};
    }
};

}  // namespace

/// Structure of a crystal that fills the box, see crystal_order.hpp.
AnalysisMethod crystal() {
    return {.name = "crystal",
            .meaning =
                "displacements from the sites of a crystal that fills the box, Lindemann ratio, Bragg peaks and "
                "Debye-Waller factors, written to bragg.csv",
            .files = {"bragg"},
            .follows_time = false,
            .needs = {.fixed_box = false},
            .of_crystal = true,
            .quantities = {{"site_displacement", "<u^2>", "sigma^2"},
                           {"site_displacement_debye_waller", "<u^2>_DW", "sigma^2"},
                           {"lindemann_ratio", "<u^2>^(1/2)/d", ""},
                           {"vacant_sites", "vacant", ""},
                           {"debye_waller_factor", "exp(-2 W)", ""},
                           {"debye_waller_gaussian", "exp(-k^2 <u^2>/3)", ""},
                           {"bragg_peak", "S(k_1)/N", ""},
                           {"vectors", "vectors", ""},
                           {"k", "k sigma", ""},
                           {"S", "S(k)", ""}},
            .charts = {{.file = "bragg",
                        .x = "k",
                        .y = "debye_waller_factor",
                        .title = "Bragg peaks",
                        .caption = "Height S(k)/N of the peaks, 1 in a crystal at rest. The line is exp(-k^2 <u^2>/3) "
                                   "of the measured displacements; on this scale it is nearly straight in k^2.",
                        .lead = true,
                        .expected = "debye_waller_gaussian",
                        .expected_label = "from displacements",
                        .logarithmic = true}},
            .options = [] { return std::make_unique<CrystalOptions>(); }};
}

}  // namespace ljmd
