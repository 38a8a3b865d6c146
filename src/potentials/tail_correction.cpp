#include "ljmd/detail/potentials/tail_correction.hpp"

#include <numbers>

namespace ljmd {

double TailCorrection::energy(double density) const {
    return 2.0 * std::numbers::pi * density * integrals_.energy;
}

double TailCorrection::pressure(double density) const {
    return 2.0 * std::numbers::pi / 3.0 * density * density * integrals_.virial;
}

}  // namespace ljmd
