#include "observables/widom_insertion.hpp"

namespace ljmd {

namespace {

struct ChemicalPotentialOptions : AnalysisOptions {
    Index every = 200;
    std::optional<Index> insertions = {};

    void describe(Description& description) override {
        description.integer("every", every).at_least(1).step_interval().meaning("steps between configurations");
        description.integer("insertions", insertions)
            .at_least(1)
            .at_most(1e9)
            .optional("as many as there are atoms")
            .meaning("places that are tried in each configuration");
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        return std::make_unique<WidomInsertion>(run, insertions.value_or(run.atoms), Every(every));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        constexpr double of_atom = 20.0;   // its place and its images' places in the order of a grid
        constexpr double of_copy = 230.0;  // of the state, sorted, with images
        const auto atoms = static_cast<double>(run.atoms);
        return {.kept = BlockingAccumulator::bytes(4, Covariance::full, run.steps / every + 1),
                .fixed = of_atom * atoms,
                .passing = of_copy * atoms};
    }
};

}  // namespace

/// Excess chemical potential, see widom_insertion.hpp.
AnalysisMethod chemical_potential() {
    return {.name = "chemical_potential",
            .meaning = "excess chemical potential by Widom's insertion of test particles",
            .files = {},
            .follows_time = false,
            .needs = {.velocities = true, .interaction = true},
            .is_random = true,
            .quantities = {{"excess_chemical_potential", "mu_ex", "epsilon"}},
            .options = [] { return std::make_unique<ChemicalPotentialOptions>(); }};
}

}  // namespace ljmd
