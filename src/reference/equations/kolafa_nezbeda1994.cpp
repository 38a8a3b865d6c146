#include <array>
#include <numbers>

#include "ljmd/detail/reference/equation_of_state.hpp"

namespace ljmd {

namespace {

/// c T^(i/2)
struct RootTerm {
    int i;
    double c;
};

/// C T^(i/2) rho^j
struct PairTerm {
    int i;
    int j;
    double c;
};

constexpr double gamma = 1.92907278;
constexpr double diameter_logarithm = -0.063920968;
constexpr std::array<RootTerm, 4> diameter{{{-2, 0.011117524}, {-1, -0.076383859}, {0, 1.080142248}, {1, 0.000693129}}};
constexpr std::array<RootTerm, 7> virial{{{-7, -0.58544978},
                                          {-6, 0.43102052},
                                          {-5, 0.87361369},
                                          {-4, -4.13749995},
                                          {-3, 2.90616279},
                                          {-2, -7.02181962},
                                          {0, 0.02459877}}};
constexpr std::array<PairTerm, 19> perturbation{{{0, 2, 2.01546797},
                                                 {0, 3, -28.17881636},
                                                 {0, 4, 28.28313847},
                                                 {0, 5, -10.42402873},
                                                 {-1, 2, -19.58371655},
                                                 {-1, 3, 75.62340289},
                                                 {-1, 4, -120.70586598},
                                                 {-1, 5, 93.92740328},
                                                 {-1, 6, -27.37737354},
                                                 {-2, 2, 29.3447052},
                                                 {-2, 3, -112.35356937},
                                                 {-2, 4, 170.6490898},
                                                 {-2, 5, -123.06669187},
                                                 {-2, 6, 34.42288969},
                                                 {-4, 2, -13.37031968},
                                                 {-4, 3, 65.3805957},
                                                 {-4, 4, -115.09233113},
                                                 {-4, 5, 88.91973082},
                                                 {-4, 6, -25.6209989}}};

Taylor power(const Taylor& temperature, int i) {
    return pow(temperature, 0.5 * i);
}

Taylor sum_of(const auto& terms, const Taylor& temperature) {
    Taylor sum;
    for (const RootTerm& term : terms) {
        sum += term.c * power(temperature, term.i);
    }
    return sum;
}

/// A_res/(N k_B T) of hard spheres with packing fraction y. Source: J. Kolafa, quoted as equation 5 of the paper.
Taylor hard_spheres(const Taylor& y) {
    const Taylor hole = 1.0 - y;
    return 5.0 / 3.0 * log1p(-y) + y * (34.0 - 33.0 * y + 4.0 * y * y) / (6.0 * hole * hole);
}

/// Equations 29 and 30.
Taylor residual(const Taylor& temperature, const Taylor& density) {
    const Taylor d = diameter_logarithm * log(temperature) + sum_of(diameter, temperature);
    Taylor sum;
    for (const PairTerm& term : perturbation) {
        sum += term.c * power(temperature, term.i) * pow(density, term.j);
    }
    const Taylor y = std::numbers::pi / 6.0 * density * d * d * d;
    return hard_spheres(y) + exp(-gamma * density * density) * density * sum_of(virial, temperature) +
           sum / temperature;
}

}  // namespace

EquationOfState kolafa_nezbeda1994() {
    return {.name = "kolafa-nezbeda1994",
            .meaning = "Kolafa and Nezbeda: the full Lennard-Jones fluid",
            .source = "J. Kolafa, I. Nezbeda, Fluid Phase Equilib. 100, 1 (1994), doi:10.1016/0378-3812(94)80001-4",
            .full_potential = true,
            .valid = {.lowest_temperature = 0.68, .highest_temperature = 10.0, .highest_density = 1.2},
            .residual_helmholtz = residual};
}

}  // namespace ljmd
