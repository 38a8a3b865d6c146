#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace ljmd::test {

/// kolmogorov_smirnov is above that once in a million times: for numbers that a chaotic trajectory yields.
constexpr double one_in_a_million = 2.69;

/// Largest distance between the distribution of the numbers and F, times sqrt(n): below 1.63 with 99 % probability.
/// @pre the numbers are independent
template <class Distribution>
double kolmogorov_smirnov(std::vector<double> x, const Distribution& f) {
    std::sort(x.begin(), x.end());
    const auto n = static_cast<double>(x.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const auto below = static_cast<double>(k);
        largest = std::max({largest, f(x[k]) - below / n, (below + 1.0) / n - f(x[k])});
    }
    return largest * std::sqrt(n);
}

}  // namespace ljmd::test
