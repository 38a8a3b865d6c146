#include "model/checksum.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <bit>
#include <cstdint>
#include <memory>

#include "execution/ranks.hpp"
#include "ljmd/core/errors.hpp"
#include "model/atoms_by_id.hpp"

namespace ljmd {

namespace {

using Hash = std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)>;

Hash begun_hash() {
    Hash hash(XXH3_createState(), XXH3_freeState);
    XXH3_64bits_reset(hash.get());
    return hash;
}

std::string in_words(std::uint64_t hash) {
    return fmt::format("xxh3:{:016x}", hash);
}

/// At rank 0.
std::uint64_t hash_of(const State& state) {
    const Hash hash = begun_hash();
    visit_by_id(state, {.positions = true}, [&](const AtomPiece& piece) {
        for (std::size_t k = 0; k < piece.positions.size(); ++k) {
            const Vec3& r = piece.positions[k];
            const Vec3 n = state.has_box() ? state.box().crossings(r) : Vec3::Zero();
            const Vec3 wrapped = state.has_box() ? Vec3(r - n.cwiseProduct(state.box().edges())) : r;
            const Vec3 image = piece.images[k].cast<double>() + n;
            // Adding zero turns -0 into +0.
            const std::array<double, 6> atom{wrapped[0] + 0.0, wrapped[1] + 0.0, wrapped[2] + 0.0,
                                             image[0] + 0.0,   image[1] + 0.0,   image[2] + 0.0};
            XXH3_64bits_update(hash.get(), atom.data(), sizeof(atom));
        }
    });
    return XXH3_64bits_digest(hash.get());
}

}  // namespace

std::string checksum(const State& state) {
    Ranks& ranks = state.execution().ranks();
    std::int64_t unsound = state.positions().allFinite() ? 0 : 1;
    ranks.sum({&unsound, 1});
    if (unsound > 0) {
        throw PhysicsError("a position is not finite: the run has blown up. Is the time step too large?");
    }
    std::int64_t bits = 0;
    look_by_id(state, [&] { bits = std::bit_cast<std::int64_t>(hash_of(state)); });
    ranks.sum({&bits, 1});  // of the others it is zero
    return in_words(std::bit_cast<std::uint64_t>(bits));
}

std::string checksum(const Configuration& configuration) {
    const Hash hash = begun_hash();
    const auto add = [&](const auto& values) {
        const std::uint64_t count = std::size(values);
        XXH3_64bits_update(hash.get(), &count, sizeof(count));
        XXH3_64bits_update(hash.get(), std::data(values), count * sizeof(*std::data(values)));
    };
    add(std::array{configuration.edges});
    add(configuration.positions);
    add(configuration.velocities);
    add(configuration.masses);
    add(std::array{configuration.time.value_or(0.0)});
    add(std::array{configuration.step.value_or(0)});
    return in_words(XXH3_64bits_digest(hash.get()));
}

}  // namespace ljmd
