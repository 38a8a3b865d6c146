#include "ljmd/app/checksum.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <vector>

#include "ljmd/core/errors.hpp"

namespace ljmd {

std::string checksum(State state) {
    if (state.has_box()) {
        state.wrap();
    }
    const auto r = static_cast<const State&>(state).positions();
    if (!r.allFinite()) {
        throw PhysicsError("a position is not finite: the run has blown up. Is the time step too large?");
    }
    std::vector<std::array<double, 6>> atoms(static_cast<std::size_t>(state.count()));
    for (Index i = 0; i < state.count(); ++i) {
        const Eigen::Vector3d n = state.image(i).cast<double>();
        // Adding zero makes -0 and +0 the same.
        atoms[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])] = {
            r(0, i) + 0.0, r(1, i) + 0.0, r(2, i) + 0.0, n[0], n[1], n[2]};
    }
    return fmt::format("xxh3:{:016x}", XXH3_64bits(atoms.data(), atoms.size() * sizeof(atoms.front())));
}

}  // namespace ljmd
