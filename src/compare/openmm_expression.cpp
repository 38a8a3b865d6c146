#include "compare/openmm_expression.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Written independently of truncation.hpp, because this is the other side of a comparison.
constexpr std::array<std::pair<const char*, const char*>, 4> truncations{{
    {"cut", "u"},
    {"shifted", "u-u_cutoff"},
    {"force-shifted", "u-u_cutoff+(r-cutoff)*f_cutoff"},
    {"switched",
     "u*s; s=select(step(r-switch_start), 1-10*x^3+15*x^4-6*x^5, 1); x=(r-switch_start)/(cutoff-switch_start)"},
}};

}  // namespace

std::string openmm_expression(const PairPotential& potential) {
    for (const auto& [name, energy] : truncations) {
        if (potential.truncation() == name) {
            return fmt::format("{}; u={}", energy, openmm_formula(potential));
        }
    }
    throw InputError(fmt::format("the truncation '{}' is not known in OpenMM", potential.truncation()));
}

std::string openmm_formula(const PairPotential& potential) {
    // A definition applies to everything before it, so the last r is the distance itself.
    return potential.expression() + "; r=scale*r";
}

}  // namespace ljmd
