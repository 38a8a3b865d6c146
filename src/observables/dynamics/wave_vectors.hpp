#pragma once

#include <array>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// A wave vector of a periodic box, k = 2 pi (n_x/L_x, n_y/L_y, n_z/L_z). Of each pair k and -k there is one: the
/// first of its numbers that is not 0 is positive.
struct WaveVector {
    std::array<Index, 3> numbers;
    Vec3 k;         ///< [1/sigma]
    double length;  ///< |k|
};

/// Wave vectors of nearly the same length.
struct WaveShell {
    double k;  ///< mean of their lengths [1/sigma]
    std::vector<WaveVector> vectors;
};

/// Shells at equally spaced wave numbers from k_min to k_max, each of the vectors of the box whose lengths are nearest,
/// and within 5 % of the nearest one's: so the shells of the smallest wave numbers have one length each. Among equal
/// lengths, vectors with the largest numbers first along x, then along y, then along z take turns, so that three
/// vectors (n, 0, 0) of a cube are one along each edge. No length is in two shells; a shell that would have no vector
/// is left out.
/// @param most  vectors in a shell
/// @throws ContractViolation unless 0 < k_min <= k_max, shells >= 1, most >= 1
[[nodiscard]] std::vector<WaveShell> wave_shells(const Box& box, double k_min, double k_max, Index shells, Index most);

/// The smallest wave number of a box, 2 pi/L of its longest edge.
[[nodiscard]] double smallest_wave_number(const Box& box);

}  // namespace ljmd
