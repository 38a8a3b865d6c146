#pragma once

#include "core/random.hpp"
#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd::test {

/// Atoms that do not feel each other: random positions, velocities of Maxwell's distribution at temperature 1 in the
/// frame of the centre of mass, both new at each start. The analysis samples `frames` frames a time `spacing` apart of
/// each start, with an interruption between two.
inline void sample_ideal_gas(Analysis& analysis, Index atoms, double edge, Index starts, Index frames, double spacing) {
    const Random random(11, RandomStream::velocities);
    for (Index start = 0; start < starts; ++start) {
        Eigen::Matrix3Xd positions(3, atoms);
        Eigen::Matrix3Xd velocities(3, atoms);
        for (Index i = 0; i < atoms; ++i) {
            // A sequence that fills the box evenly enough, another one at each start.
            const double place = static_cast<double>(i + 1 + start * atoms);
            for (Index axis = 0; axis < 3; ++axis) {
                const double step = axis == 0 ? 0.8191725134 : axis == 1 ? 0.6710436067 : 0.5497004779;
                positions(axis, i) = edge * (place * step - std::floor(place * step));
            }
            velocities.col(i) = random.normal(start, i);
        }
        velocities.colwise() -= Vec3(velocities.rowwise().mean());
        for (Index frame = 0; frame < frames; ++frame) {
            State state(atoms, Box(Vec3(edge, edge, edge)));
            auto r = state.write_positions();
            for (Index i = 0; i < atoms; ++i) {
                r.col(i) = positions.col(i) + static_cast<double>(frame) * spacing * velocities.col(i);
            }
            state.write_velocities() = velocities;
            analysis.sample(state, Evaluation{});
        }
        analysis.interrupt();
    }
}

}  // namespace ljmd::test
