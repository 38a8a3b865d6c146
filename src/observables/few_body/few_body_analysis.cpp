#include "observables/few_body/few_body_analysis.hpp"

#include "ljmd/options/choice.hpp"

namespace ljmd {

Chosen<FewBodyAnalysisMethod, FewBodyAnalysisOptions> chosen_few_body_analysis(const Choice& choice) {
    return chosen(all_few_body_analyses(), choice, "analysis of few bodies");
}

}  // namespace ljmd
