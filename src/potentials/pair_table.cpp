#include "potentials/pair_table.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr auto points = static_cast<int>(PairTable::degree + 1);

/// In extended precision where there is one: then the polynomials round no worse than their energies.
using Matrix = Eigen::Matrix<long double, points, points>;
using Vector = Eigen::Matrix<long double, points, 1>;

/// The points of a piece, from -1 to 1.
Vector lobatto_points() {
    Vector t;
    for (int k = 0; k < points; ++k) {
        t[k] = -std::cos(std::numbers::pi_v<long double> * static_cast<long double>(k) / (points - 1));
    }
    return t;
}

/// Makes coefficients of energies at the points.
Matrix interpolation() {
    const Vector t = lobatto_points();
    Matrix powers;
    for (int k = 0; k < points; ++k) {
        powers.col(k) = t.array().pow(static_cast<long double>(k));
    }
    return powers.inverse();
}

void check(double first, double last, Index pieces) {
    if (!(std::isfinite(first) && std::isfinite(last) && 0.0 <= first && first < last)) {
        throw InputError(
            fmt::format("a table from {} to {}: it goes from 0 or more to a larger distance", first, last));
    }
    if (pieces < 1 || pieces > PairTable::max_pieces) {
        throw InputError(fmt::format("a table of {} pieces: allowed are 1 to {}", pieces, PairTable::max_pieces));
    }
}

/// @throws InputError  no table has so many energies
Index pieces_of(const std::vector<double>& energies) {
    const auto size = static_cast<Index>(energies.size());
    if (size % PairTable::degree != 1) {
        throw InputError(
            fmt::format("a table of {} energies: it takes {} for each piece, and one more", size, PairTable::degree));
    }
    return size / PairTable::degree;
}

}  // namespace

std::vector<double> PairTable::distances(double first, double last, Index pieces) {
    check(first, last, pieces);
    const Vector t = lobatto_points();
    const long double length = (static_cast<long double>(last) - first) / static_cast<long double>(pieces);
    std::vector<double> r{first};
    r.reserve(static_cast<std::size_t>(degree * pieces + 1));
    for (Index piece = 0; piece < pieces; ++piece) {
        for (int k = 1; k < points; ++k) {
            r.push_back(static_cast<double>(first + length * (static_cast<long double>(piece) + 0.5L * (1.0L + t[k]))));
        }
    }
    r.back() = last;
    return r;
}

PairTable::PairTable(double first, double last, const std::vector<double>& energies) : first_(first) {
    const Index pieces = pieces_of(energies);
    const std::vector<double> r = distances(first, last, pieces);
    for (std::size_t k = 0; k < energies.size(); ++k) {
        if (!std::isfinite(energies[k])) {
            throw InputError(fmt::format("a table has finite energies; found {} at r = {}", energies[k], r[k]));
        }
    }
    pieces_per_length_ = static_cast<double>(pieces) / (last - first);
    last_piece_ = static_cast<double>(pieces - 1);
    const Matrix of_energies = interpolation();
    coefficients_.resize(static_cast<std::size_t>(pieces));
    for (std::size_t piece = 0; piece < coefficients_.size(); ++piece) {
        Vector u;
        for (int k = 0; k < points; ++k) {
            u[k] = energies[piece * degree + static_cast<std::size_t>(k)];
        }
        const Vector c = of_energies * u;
        for (int k = 0; k < points; ++k) {
            coefficients_[piece][static_cast<std::size_t>(k)] = static_cast<double>(c[k]);
        }
    }
    u_first_ = energies.front();
    long double slope = 0.0L;  // of the first polynomial at t = -1
    for (int k = 1; k < points; ++k) {
        slope += (k % 2 == 1 ? 1.0L : -1.0L) * k * coefficients_.front()[static_cast<std::size_t>(k)];
    }
    slope_first_ = 2.0 * pieces_per_length_ * static_cast<double>(slope);
}

}  // namespace ljmd
