#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#include "catch.hpp"

#include "forces/made_few_body_force.hpp"
#include "observables/few_body/few_body_analysis.hpp"

namespace ljmd::test {

using Integers = std::vector<std::pair<std::string, std::int64_t>>;

/// What an analysis looks at, and everything it refers to.
struct MadeTarget {
    MadeTarget(Index bodies, int dimensions, const std::string& name, const Numbers& numbers)
        : force(chosen_few_body_force(name, numbers)), target{bodies, dimensions, force} {}
    MadeTarget(const MadeTarget&) = delete;
    MadeTarget& operator=(const MadeTarget&) = delete;

    ChosenFewBodyForce force;
    FewBodyTarget target;
};

inline FewBodyAnalysisMethod few_body_analysis_method(const std::string& name) {
    const auto methods = all_few_body_analyses();
    const auto found =
        std::find_if(methods.begin(), methods.end(), [&](const auto& method) { return method.name == name; });
    REQUIRE(found != methods.end());
    return *found;
}

/// The section of an analysis as a deck gives it. Keys that are not given take their defaults.
inline Section few_body_analysis_section(const FewBodyAnalysisMethod& method, const Integers& settings) {
    Table table;
    for (const auto& [key, value] : settings) {
        table.push_back({key, {}, {value, {}}});
    }
    Diagnostics diagnostics;
    Section section = validate(table, {}, Schema(method.name, keys_of(method)), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    return section;
}

inline std::unique_ptr<FewBodyAnalysis> made_few_body_analysis(const std::string& name, const Integers& settings,
                                                               const FewBodyTarget& target) {
    const auto method = few_body_analysis_method(name);
    const Section section = few_body_analysis_section(method, settings);
    return choose(method, section).options->make(target);
}

/// The keys that an analysis finds fault with.
inline std::vector<std::string> faults(const std::string& name, const Integers& settings, const FewBodyTarget& target) {
    const auto method = few_body_analysis_method(name);
    const Section section = few_body_analysis_section(method, settings);
    std::vector<std::string> keys;
    for (const auto& [key, message] : choose(method, section).options->check(target)) {
        CHECK_FALSE(message.empty());
        keys.push_back(key);
    }
    return keys;
}

/// NaN when it has not been found.
inline double finding(const FewBodyAnalysis& analysis, const std::string& name) {
    for (const Finding& finding : analysis.findings()) {
        if (finding.name == name) {
            return finding.value;
        }
    }
    return std::nan("");
}

inline bool has_finding(const FewBodyAnalysis& analysis, const std::string& name) {
    const auto all = analysis.findings();
    return std::any_of(all.begin(), all.end(), [&](const Finding& finding) { return finding.name == name; });
}

}  // namespace ljmd::test
