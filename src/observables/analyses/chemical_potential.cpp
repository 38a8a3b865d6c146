#include "ljmd/observables/widom_insertion.hpp"

namespace ljmd {

/// Excess chemical potential, see widom_insertion.hpp.
AnalysisMethod chemical_potential() {
    return {
        .name = "chemical_potential",
        .meaning = "excess chemical potential by Widom's insertion of test particles",
        .files = {},
        .follows_time = false,
        .needs = {.velocities = true, .interaction = true},
        .is_random = true,
        .keys =
            {Key::integer("every").at_least(1).defaults_to(std::int64_t{200}).meaning("steps between configurations"),
             Key::integer("insertions")
                 .at_least(1)
                 .at_most(1e9)
                 .optional("as many as there are atoms")
                 .meaning("places that are tried in each configuration")},
        .check = [](const Section&, const SampledRun&) -> std::vector<std::pair<std::string, std::string>> {
            return {};
        },
        .make = [](const Section& section, const SampledRun& run) -> std::unique_ptr<Analysis> {
            const Index insertions = section.has("insertions") ? section.integer("insertions") : run.atoms;
            return std::make_unique<WidomInsertion>(run, insertions, Every(section.integer("every")));
        },
        .size = [](const Section& section, const SampledRun& run) -> AnalysisSize {
            constexpr double of_atom = 20.0;   // bytes: its index and those of its images in the order of a grid
            constexpr double of_copy = 230.0;  // bytes: copy of the state, sorted, with images
            const auto atoms = static_cast<double>(run.atoms);
            return {.kept = BlockingAccumulator::bytes(4, Covariance::full, run.steps / section.integer("every") + 1),
                    .fixed = of_atom * atoms,
                    .passing = of_copy * atoms};
        }};
}

}  // namespace ljmd
