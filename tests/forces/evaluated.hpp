#pragma once

#include <cmath>
#include <cstdint>

#include "forces/pair_force_field.hpp"
#include "neighbors/sample_states.hpp"

namespace ljmd::test {

/// 108 atoms of a dense fluid; L = 5.04 is hardly more than 2 rc.
inline State fluid(std::uint64_t seed = 5) {
    return shaken_crystal(3, 0.8442, 0.15, seed);
}

inline double rms(const Eigen::Matrix3Xd& f) {
    return f.norm() / std::sqrt(static_cast<double>(f.cols()));
}

/// Forces by atom id, and what the evaluation returned.
struct Evaluated {
    Eigen::Matrix3Xd forces;
    Evaluation evaluation;
};

inline Evaluated evaluate(PairForceField force_field, State state, Request request = Request::forces_and_energy) {
    const Evaluation evaluation = force_field.evaluate(state, request);
    return {by_id(state, state.forces()), evaluation};
}

}  // namespace ljmd::test
