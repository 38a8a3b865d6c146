#include "ljmd/detail/observables/analysis.hpp"

#include "ljmd/options/choice.hpp"

namespace ljmd {

AnalysisMethod find_analysis(const std::string& name) {
    return find_plugin(all_analyses(), name, "analysis");
}

ChosenAnalysis chosen_analysis(const Choice& choice) {
    return chosen(all_analyses(), choice, "analysis");
}

}  // namespace ljmd
