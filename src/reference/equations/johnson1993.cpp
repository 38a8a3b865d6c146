#include <array>

#include "ljmd/detail/reference/equation_of_state.hpp"

namespace ljmd {

namespace {

constexpr double gamma = 3.0;
constexpr std::size_t parameters = 32;
constexpr std::size_t powers = 8;     ///< of the density
constexpr std::size_t gaussians = 6;  ///< of the density

/// Table 10; x[i - 1] is the paper's x_i.
constexpr std::array<double, parameters> x{
    0.8623085097507421, 2.976218765822098,  -8.402230115796039, 0.1054136629203555, -0.8564583828174598,
    1.582759470107601,  0.7639421948305453, 1.753173414312048,  2798.291772190376,  -0.04839422026085766,
    0.9963265197721936, -36.98000291272493, 20.84012299434647,  83.05402124717286,  -957.4799715203068,
    -147.7746229234994, 63.98607852471505,  16.03993673294834,  68.05916615864378,  -2791.293578795945,
    -6.245128304568454, -8116.83610495841,  14.88735559561229,  -10593.46754655084, -113.1607632802822,
    -8867.771540418822, -39.86982844450543, -4689.270299917261, 259.3535277438717,  -2694.523589434903,
    -721.8487631550215, 172.1802063863269};

/// a_1 to a_8 of Table 5.
std::array<Taylor, powers> coefficients_a(const Taylor& t) {
    const Taylor root = pow(t, 0.5);
    const Taylor t1 = 1.0 / t;
    const Taylor t2 = t1 * t1;
    return {x[0] * t + x[1] * root + x[2] + x[3] * t1 + x[4] * t2,
            x[5] * t + x[6] + x[7] * t1 + x[8] * t2,
            x[9] * t + x[10] + x[11] * t1,
            x[12],
            x[13] * t1 + x[14] * t2,
            x[15] * t1,
            x[16] * t1 + x[17] * t2,
            x[18] * t2};
}

/// b_1 to b_6 of Table 6.
std::array<Taylor, gaussians> coefficients_b(const Taylor& t) {
    const Taylor t1 = 1.0 / t;
    const Taylor t2 = t1 * t1;
    const Taylor t3 = t2 * t1;
    const Taylor t4 = t2 * t2;
    return {x[19] * t2 + x[20] * t3, x[21] * t2 + x[22] * t4, x[23] * t2 + x[24] * t3,
            x[25] * t2 + x[26] * t4, x[27] * t2 + x[28] * t3, x[29] * t2 + x[30] * t3 + x[31] * t4};
}

/// For smaller z, the series of G_6 below converges within 40 terms. From it on, the upward recursion is as accurate.
constexpr double largest_series_argument = 6.0;
constexpr int series_terms = 40;

/// G_6 = integral from 0 to rho of x^11 exp(-gamma x^2) dx = rho^12/2 F (1/6 + z/(6 7) + z^2/(6 7 8) + ...), with z =
/// gamma rho^2 and all terms positive. Source: NIST Digital Library of Mathematical Functions, 8.7.1
Taylor last_integral(const Taylor& density2, const Taylor& f) {
    const Taylor z = gamma * density2;
    constexpr int n = gaussians;
    Taylor term = 1.0 / static_cast<double>(n);
    Taylor sum = term;
    for (int k = 1; k < series_terms; ++k) {
        term *= z / static_cast<double>(n + k);
        sum += term;
    }
    return 0.5 * pow(density2, n) * f * sum;
}

/// G_1 to G_6 of Table 7, G_i = integral from 0 to rho of x^(2i - 1) exp(-gamma x^2) dx.
///
/// The paper uses the upward recursion G_1 = (1 - F)/(2 gamma), G_(i + 1) = (2 i G_i - F rho^(2 i))/(2 gamma). At low
/// densities it suffers from cancellation: G_6 is of the order rho^12, from terms of the order rho^2. Solved for G_i,
/// the same relation adds positive terms.
std::array<Taylor, gaussians> integrals_g(const Taylor& density) {
    const Taylor density2 = density * density;
    const Taylor f = exp(-gamma * density2);
    std::array<Taylor, gaussians> power;  // rho^(2 (i + 1))
    power[0] = density2;
    for (std::size_t i = 1; i < gaussians; ++i) {
        power[i] = power[i - 1] * density2;
    }
    std::array<Taylor, gaussians> g;
    if (gamma * density2.value() < largest_series_argument) {
        g[gaussians - 1] = last_integral(density2, f);
        for (std::size_t i = gaussians - 1; i > 0; --i) {
            g[i - 1] = (2.0 * gamma * g[i] + f * power[i - 1]) / (2.0 * static_cast<double>(i));
        }
    } else {
        g[0] = (1.0 - f) / (2.0 * gamma);
        for (std::size_t i = 1; i < gaussians; ++i) {
            g[i] = (2.0 * static_cast<double>(i) * g[i - 1] - f * power[i - 1]) / (2.0 * gamma);
        }
    }
    return g;
}

/// Equation 5, divided by k_B T: A_res/N = sum of a_i rho^i / i + sum of b_i G_i.
Taylor residual(const Taylor& temperature, const Taylor& density) {
    const auto a = coefficients_a(temperature);
    const auto b = coefficients_b(temperature);
    const auto g = integrals_g(density);
    Taylor energy;
    Taylor power = 1.0;
    for (std::size_t i = 0; i < powers; ++i) {
        power *= density;
        energy += a[i] * power / static_cast<double>(i + 1);
    }
    for (std::size_t i = 0; i < gaussians; ++i) {
        energy += b[i] * g[i];
    }
    return energy / temperature;
}

}  // namespace

EquationOfState johnson1993() {
    return {.name = "johnson1993",
            .meaning = "Johnson, Zollweg and Gubbins: the full Lennard-Jones fluid",
            .source =
                "J. K. Johnson, J. A. Zollweg, K. E. Gubbins, Mol. Phys. 78, 591 (1993), "
                "doi:10.1080/00268979300100411",
            .full_potential = true,
            .valid = {.lowest_temperature = 0.7, .highest_temperature = 6.0, .highest_density = 1.25},
            .residual_helmholtz = residual};
}

}  // namespace ljmd
