#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace ljmd {

/// Counts and indices of atoms, pairs and steps. 64 bits, because 3 N and the number of pairs overflow 32.
using Index = std::int64_t;

/// A vector in space: position [sigma], velocity [sigma/tau], force [epsilon/sigma].
using Vec3 = Eigen::Vector3d;

/// A second-rank tensor in space: virial [epsilon], pressure [epsilon/sigma^3].
using Mat3 = Eigen::Matrix3d;

/// Numbers from one atom's vector to the next atom's: x, y, z and a zero, so that each begins at a multiple of 32
/// bytes.
inline constexpr Index vector_stride = 4;

}  // namespace ljmd
