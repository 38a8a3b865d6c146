#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ljmd/integrators/operators.hpp"

namespace ljmd {

/// A way to advance Newton's equations by one step, as a list of operators. One file in src/integrators/methods each.
struct IntegratorMethod {
    std::string name;     ///< as a deck selects it
    std::string meaning;  ///< one line for the reference page
    int order;            ///< of its global error: halving the step divides the error by 2^order
    bool reversible;      ///< returns to its start when velocities are reversed
    std::function<std::vector<Operator>(double time_step)> step;
};

/// Every integrator there is, in alphabetical order.
[[nodiscard]] std::vector<IntegratorMethod> all_integrators();

/// @throws InputError for an unknown name
[[nodiscard]] IntegratorMethod find_integrator(const std::string& name);

}  // namespace ljmd
