#pragma once

#include <vector>

#include "ljmd/detail/core/taylor.hpp"

namespace ljmd {

/// Functional form of Thol's equations, with tau = T_r/T and delta = rho/rho_r:
///
///     A_res/(N k_B T) = sum of n tau^t delta^d
///                     + sum of n tau^t delta^d exp(-delta^l)
///                     + sum of n tau^t delta^d exp(-eta (delta - epsilon)^2 - beta (tau - gamma)^2)
///
/// Source: M. Thol and others (2016), equation 8, doi:10.1063/1.4945000
struct MultiparameterForm {
    struct Power {
        double n, t;
        int d;
    };
    struct Exponential {
        double n, t;
        int d, l;
    };
    struct Gaussian {
        double n, t;
        int d;
        double eta, beta, gamma, epsilon;
    };

    double reducing_temperature;
    double reducing_density;
    std::vector<Power> power;
    std::vector<Exponential> exponential;
    std::vector<Gaussian> gaussian;
};

/// A_res/(N k_B T) in this form. @pre temperature > 0, density >= 0
[[nodiscard]] Taylor residual_helmholtz(const MultiparameterForm& form, const Taylor& temperature,
                                        const Taylor& density);

}  // namespace ljmd
