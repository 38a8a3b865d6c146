#include "ljmd/detail/reference/equation_of_state.hpp"
#include "reference/multiparameter.hpp"

namespace ljmd {

EquationOfState thol2015() {
    // Table 1.
    static const MultiparameterForm form{
        .reducing_temperature = 1.086,
        .reducing_density = 0.319,
        .power = {{0.015606084, 1.0, 4},
                  {1.7917527, 0.304, 1},
                  {-1.9613228, 0.583, 1},
                  {1.3045604, 0.662, 2},
                  {-1.8117673, 0.87, 2},
                  {0.15483997, 0.87, 3}},
        .exponential = {{-0.094885204, 1.25, 5, 1},
                        {-0.20092412, 3.0, 2, 2},
                        {0.11639644, 1.7, 2, 1},
                        {-0.50607364, 2.4, 3, 2},
                        {-0.58422807, 1.96, 1, 2},
                        {-0.47510982, 1.286, 1, 1}},
        .gaussian = {{0.0094333106, 3.6, 1, 4.7, 20.0, 1.0, 0.55},
                     {0.30444628, 2.08, 1, 1.92, 0.77, 0.5, 0.7},
                     {-0.0010820946, 5.24, 2, 2.7, 0.5, 0.8, 2.0},
                     {-0.099693391, 0.96, 3, 1.49, 0.8, 1.5, 1.14},
                     {0.0091193522, 1.36, 3, 0.65, 0.4, 0.7, 1.2},
                     {0.12970543, 1.655, 2, 1.73, 0.43, 1.6, 1.31},
                     {0.02303603, 0.9, 1, 3.7, 8.0, 1.3, 1.14},
                     {-0.082671073, 0.86, 2, 1.9, 3.3, 0.6, 0.53},
                     {-2.2497821, 3.95, 3, 13.2, 114.0, 1.3, 0.96}},
    };
    return {.name = "thol2015",
            .meaning = "Thol and others: truncated at 2.5 sigma and shifted",
            .source =
                "M. Thol, G. Rutkai, R. Span, J. Vrabec, R. Lustig, Int. J. Thermophys. 36, 25 (2015), "
                "doi:10.1007/s10765-014-1764-4",
            .full_potential = false,
            .valid = {.lowest_temperature = 0.6, .highest_temperature = 10.0, .highest_pressure = 70.0},
            .residual_helmholtz = [](const Taylor& temperature, const Taylor& density) {
                return residual_helmholtz(form, temperature, density);
            }};
}

}  // namespace ljmd
