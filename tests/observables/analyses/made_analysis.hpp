#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>
#include "catch.hpp"

#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/options/section.hpp"

namespace ljmd::test {

using AnalysisSettings = std::vector<std::pair<std::string, std::variant<std::int64_t, double, std::string>>>;

inline AnalysisMethod analysis_method(const std::string& name) {
    const auto methods = all_analyses();
    const auto found =
        std::find_if(methods.begin(), methods.end(), [&](const AnalysisMethod& method) { return method.name == name; });
    REQUIRE(found != methods.end());
    return *found;
}

/// A run of 10000 steps that all are sampled.
inline SampledRun run_of(const State& state) {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    return {state.count(),
            state.box(),
            0.004,
            10000,
            1,
            std::nullopt,
            Interaction{potential, TailCorrection(potential)},
            Ensemble::canonical};
}

/// The section of an analysis as a deck gives it. Keys that are not given take their defaults.
inline Section analysis_section(const AnalysisMethod& method, const AnalysisSettings& settings) {
    Table table;
    for (const auto& [key, setting] : settings) {
        Value value;
        std::visit([&](const auto& number) { value.data = number; }, setting);
        table.push_back({key, {}, value});
    }
    Diagnostics diagnostics;
    Section section = validate(table, {}, Schema(method.name, keys_of(method)), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    return section;
}

/// Its options with these settings.
inline std::shared_ptr<const AnalysisOptions> analysis_options(const AnalysisMethod& method,
                                                               const AnalysisSettings& settings = {}) {
    const Section section = analysis_section(method, settings);
    return choose(method, section).options;
}

}  // namespace ljmd::test
