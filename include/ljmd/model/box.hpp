#pragma once

#include "ljmd/core/types.hpp"

namespace ljmd {

/// An orthorhombic periodic box with one corner at the origin.
///
/// Coordinates lie on a grid of spacing g = `resolution()`, the smallest power of two with 2^52 g > 1.5 L, where L is
/// the longest edge; the edges lie on it, too. Doubles hold every grid point within +-3 L exactly. So a periodic image
/// is the atom plus whole edges to the last bit, r_ij = -r_ji exactly for any images, and wrapping an atom into the box
/// changes no force. The price is one rounding per step, about as coarse as a double's.
class Box {
  public:
    /// @param edges  edge lengths [sigma]; each is rounded to the grid (by less than 1e-15 of the longest)
    /// @throws InputError unless all are finite and positive, also after rounding
    explicit Box(const Vec3& edges);

    [[nodiscard]] const Vec3& edges() const { return edges_; }
    [[nodiscard]] double volume() const { return edges_.prod(); }
    [[nodiscard]] double shortest_edge() const { return edges_.minCoeff(); }

    /// Grid spacing [sigma], a power of two.
    [[nodiscard]] double resolution() const { return resolution_; }

    /// The grid point nearest to r (ties to even). Meant for -0.3 L < r < 1.1 L: above, the result lies on a coarser
    /// grid, below on a finer one, and exactness is not guaranteed.
    [[nodiscard]] Vec3 snap(const Vec3& r) const { return (r.array() + rounding_) - rounding_; }

    /// The constant that snap() adds and subtracts.
    [[nodiscard]] double rounding() const { return rounding_; }

    /// How many edges r lies outside [0, L) in each direction, as whole numbers: r - edges * crossings is inside. Exact
    /// for r on the grid and within +-3 L. Farther out the product is rounded, and the result may miss [0, L) by that
    /// rounding.
    [[nodiscard]] Vec3 crossings(const Vec3& r) const;

    /// Minimum image of a separation of two atoms inside the box: each component in [-L/2, L/2].
    /// @pre each component in (-L, L)
    [[nodiscard]] Vec3 minimum_image(const Vec3& separation) const {
        Vec3 d = separation;
        for (int a = 0; a < 3; ++a) {
            if (2.0 * d[a] > edges_[a]) {
                d[a] -= edges_[a];
            } else if (2.0 * d[a] < -edges_[a]) {
                d[a] += edges_[a];
            }
        }
        return d;
    }

  private:
    Vec3 edges_;
    double resolution_;
    double rounding_;  // adding and subtracting this rounds to the grid
};

}  // namespace ljmd
