#pragma once

#include <string>
#include <vector>

#include "compare/agreement.hpp"

namespace ljmd::test {

/// The names of the checks of a judgement that failed, in their order.
template <class Judgement>
std::vector<std::string> failed_checks(const Judgement& judged) {
    std::vector<std::string> names;
    for (const auto& check : judged.checks) {
        if (!check.passed()) {
            names.push_back(check.name);
        }
    }
    return names;
}

}  // namespace ljmd::test
