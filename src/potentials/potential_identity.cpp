#include "potentials/potential_identity.hpp"

#include <fmt/format.h>

namespace ljmd {

std::string identity(const PairPotential& potential) {
    std::string text = fmt::format("{} {} {} {}", potential.formula(), potential.truncation(),
                                   potential.cutoff().radius, potential.cutoff().switch_start);
    for (const auto& [key, value] : potential.parameters()) {
        text += fmt::format(" {}={}", key, value);
    }
    if (potential.is_custom()) {
        for (const double part : {0.3, 0.5, 0.7, 0.9}) {
            const PairTerm<double> term = potential.untruncated(part * potential.cutoff().radius);
            text += fmt::format(" {} {}", term.u, term.w);
        }
    }
    return text;
}

}  // namespace ljmd
