#pragma once

#include <array>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"

namespace ljmd {

/// A pair formula known by its values: polynomials of degree 7 in r on pieces of equal length, through the energies at
/// the Chebyshev-Lobatto points of each piece. Neighbouring pieces share a point, so the energy is continuous. The
/// force is the derivative of the same polynomials, so energy is conserved. The error of the energy falls like the 8th
/// power of the length of a piece until it reaches rounding.
///
/// Below the first distance the force is constant; beyond the last one the last polynomial goes on, so a cutoff must
/// not be longer.
/// Source: L. N. Trefethen, Approximation Theory and Approximation Practice (2013), chapters 2 and 8.
class PairTable {
  public:
    static constexpr Index degree = 7;
    static constexpr Index max_pieces = 1 << 16;

    /// The distances at which a table of so many pieces takes its energies: degree * pieces + 1, ascending.
    /// @throws InputError  unless 0 <= first < last are finite and there are 1 to max_pieces
    [[nodiscard]] static std::vector<double> distances(double first, double last, Index pieces);

    /// @param energies  u at distances(first, last, pieces) [epsilon]
    /// @throws InputError  as distances(); another number of energies, or one that is not finite
    PairTable(double first, double last, const std::vector<double>& energies);

    /// The first distance, see PairPotential::starts_at() [sigma].
    [[nodiscard]] double table_start() const { return first_; }

    PairTerm<double> operator()(const PairDistance<double>& d) const {
        if (d.r < first_) {
            return {u_first_ + slope_first_ * (d.r - first_), -slope_first_ * d.inverse_r};
        }
        const double x = (d.r - first_) * pieces_per_length_;
        const auto piece = x < last_piece_ ? static_cast<std::size_t>(x) : static_cast<std::size_t>(last_piece_);
        const Coefficients& c = coefficients_[piece];
        const double t = 2.0 * (x - static_cast<double>(piece)) - 1.0;
        double u = c[degree];
        double slope = 0.0;
        for (std::size_t k = degree; k-- > 0;) {
            slope = slope * t + u;
            u = u * t + c[k];
        }
        return {u, -2.0 * pieces_per_length_ * slope * d.inverse_r};
    }

  private:
    /// Of a polynomial in t, -1 <= t <= 1 on its piece.
    using Coefficients = std::array<double, degree + 1>;

    double first_;
    double pieces_per_length_;
    double last_piece_;  ///< index of the last piece
    std::vector<Coefficients> coefficients_;
    double u_first_;
    double slope_first_;  ///< du/dr at the first distance
};

}  // namespace ljmd
