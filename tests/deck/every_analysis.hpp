#pragma once

#include <map>
#include <string>

#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd::test {

/// A table [analysis] with every analysis of fluids there is.
/// @param tables  what is given to some of them; the others sample every step, with their defaults
inline std::string every_analysis(const std::map<std::string, std::string>& tables) {
    std::string text = "\n[analysis]\n";
    for (const AnalysisMethod& method : all_analyses()) {
        const auto table = tables.find(method.name);
        text += method.name + " = " + (table == tables.end() ? "{ every = 1 }" : table->second) + "\n";
    }
    return text;
}

}  // namespace ljmd::test
