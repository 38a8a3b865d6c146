#pragma once

#include <cstdint>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// Purpose of random numbers. Streams never share a number. The values must not change, because trajectories depend on
/// them.
enum class RandomStream : std::uint64_t {
    positions = 1,
    velocities = 2,
    insertions = 3,
    thermostat = 4,
    collisions = 5,
    barostat = 6
};

/// Counter-based random numbers (Philox-4x64-10): a pure function of seed, stream, step and atom id. There is no state,
/// so the order of atoms, the number of threads and restarts cannot change a number.
/// Source: Salmon et al., Parallel random numbers: as easy as 1, 2, 3 (2011), doi:10.1145/2063384.2063405.
class Random {
  public:
    Random(std::uint64_t seed, RandomStream stream) : seed_(seed), stream_(stream) {}

    /// Three independent numbers, uniform in [0, 1), with 53 random bits.
    [[nodiscard]] Vec3 uniform(Index step, Index atom) const;

    /// Three independent normal numbers, mean 0 and variance 1 (Box and Muller 1958,
    /// doi:10.1214/aoms/1177706645).
    [[nodiscard]] Vec3 normal(Index step, Index atom) const;

    /// A number from the gamma distribution with mean and variance `shape`: half the sum of 2 shape squared normal
    /// numbers. Independent of the stream's numbers for other atoms or steps, but not of uniform() and normal() for
    /// this one. Source: Marsaglia and Tsang 2000,
    /// doi:10.1145/358407.358414.
    /// @pre shape > 0
    [[nodiscard]] double gamma(Index step, Index atom, double shape) const;

  private:
    std::uint64_t seed_;
    RandomStream stream_;
};

}  // namespace ljmd
