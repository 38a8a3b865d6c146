#include "ljmd/detail/reference/equation_of_state.hpp"
#include "reference/multiparameter.hpp"

namespace ljmd {

EquationOfState thol2016() {
    // Table 2. The coefficient of the third term with d = 3 is -9.9218575; copies with -0.099218575 are in circulation.
    static const MultiparameterForm form{
        .reducing_temperature = 1.32,
        .reducing_density = 0.31,
        .power = {{0.005208073, 1.0, 4},
                  {2.186252, 0.32, 1},
                  {-2.161016, 0.505, 1},
                  {1.4527, 0.672, 2},
                  {-2.041792, 0.843, 2},
                  {0.18695286, 0.898, 3}},
        .exponential = {{-0.090988445, 1.294, 5, 1},
                        {-0.4974561, 2.59, 2, 2},
                        {0.10901431, 1.786, 2, 1},
                        {-0.80055922, 2.77, 3, 2},
                        {-0.568839, 1.786, 1, 2},
                        {-0.6208625, 1.205, 1, 1}},
        .gaussian = {{-1.4667177, 2.83, 1, 2.067, 0.625, 0.71, 0.2053},
                     {1.891469, 2.548, 1, 1.522, 0.638, 0.86, 0.409},
                     {-0.1383701, 4.65, 2, 8.82, 3.91, 1.94, 0.6},
                     {-0.3869645, 1.385, 3, 1.722, 0.156, 1.48, 1.203},
                     {0.1265702, 1.46, 3, 0.679, 0.157, 1.49, 1.829},
                     {0.605781, 1.351, 2, 1.883, 0.153, 1.945, 1.397},
                     {1.179189, 0.66, 1, 3.925, 1.16, 3.02, 1.39},
                     {-0.47732679, 1.496, 2, 2.461, 1.73, 1.11, 0.539},
                     {-9.9218575, 1.83, 3, 28.2, 383.0, 1.17, 0.934},
                     {-0.5747932, 1.616, 1, 0.753, 0.112, 1.33, 2.369},
                     {0.003772923, 4.97, 1, 0.82, 0.119, 0.24, 2.43}},
    };
    return {.name = "thol2016",
            .meaning = "Thol and others: the full Lennard-Jones fluid",
            .source =
                "M. Thol, G. Rutkai, A. Koester, R. Lustig, R. Span, J. Vrabec, J. Phys. Chem. Ref. Data 45, 023101 "
                "(2016), doi:10.1063/1.4945000",
            .full_potential = true,
            .valid = {.lowest_temperature = 0.661, .highest_temperature = 9.0, .highest_pressure = 65.0},
            .residual_helmholtz = [](const Taylor& temperature, const Taylor& density) {
                return residual_helmholtz(form, temperature, density);
            }};
}

}  // namespace ljmd
