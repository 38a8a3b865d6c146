#include "ljmd/model/checksum.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <memory>

#include "ljmd/core/errors.hpp"

namespace ljmd {

std::string checksum(const State& state) {
    const auto r = state.positions();
    if (!r.allFinite()) {
        throw PhysicsError("a position is not finite: the run has blown up. Is the time step too large?");
    }
    const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> hash(XXH3_createState(), XXH3_freeState);
    XXH3_64bits_reset(hash.get());
    for (const Index i : state.index_of()) {
        const Vec3 n = state.has_box() ? state.box().crossings(r.col(i)) : Vec3::Zero();
        const Vec3 wrapped = state.has_box() ? Vec3(r.col(i) - n.cwiseProduct(state.box().edges())) : Vec3(r.col(i));
        const Vec3 image = state.image(i).cast<double>() + n;
        // Adding zero turns -0 into +0.
        const std::array<double, 6> atom{wrapped[0] + 0.0, wrapped[1] + 0.0, wrapped[2] + 0.0,
                                         image[0] + 0.0,   image[1] + 0.0,   image[2] + 0.0};
        XXH3_64bits_update(hash.get(), atom.data(), sizeof(atom));
    }
    return fmt::format("xxh3:{:016x}", XXH3_64bits_digest(hash.get()));
}

}  // namespace ljmd
