#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/reference/equation_of_state.hpp"
#include "ljmd/reference/verlet1967.hpp"

/// The rows of Verlet's table computed anew, one run a row.
namespace ljmd {

/// How long the runs are.
struct ReproductionLength {
    Index melt;
    Index equilibrate;
    Index production;  ///< steps of the first part, and of each that is added while the errors are too large
    int most_parts;
    double largest_error_z;  ///< standard error of Z up to which parts are added
    double largest_error_u;  ///< that of U/N

    /// Errors of at most 0.02 in Z and 0.004 in U/N.
    static ReproductionLength full() { return {1000, 3000, 10'000, 20, 0.02, 0.004}; }

    /// As long as Verlet's own runs, 300 + 1200 steps, behind a short melting.
    static ReproductionLength quick() { return {300, 300, 1200, 1, 0.0, 0.0}; }
};

/// What a row is called in file names: "rho0.8500-T0.786".
[[nodiscard]] std::string row_name(const VerletRow& row);

/// The deck of a row: 864 atoms from the fcc lattice, molten, brought to the temperature by rescaling, then at constant
/// energy with Verlet's step 0.032 (m sigma^2/48 epsilon)^(1/2); cut at 2.5 with tail corrections.
[[nodiscard]] std::string row_deck(const VerletRow& row, const ReproductionLength& length);

/// Values of Z and U/N.
struct ZAndU {
    double z;
    double u;
};

/// What a run says of a row.
///
/// A run at constant energy has the temperature it turns out to have. Z and U are given at Verlet's temperature T_0,
/// see at_temperature().
struct ReproducedRow {
    VerletRow verlet;
    Index steps;           ///< of production
    Estimate temperature;  ///< <T>
    Estimate z;            ///< Z(T_0)
    Estimate u;            ///< U(T_0)
    ZAndU beyond_cutoff;   ///< what g(r), which is not 1 beyond the cutoff, adds to the tails: see cutoff_bias()
    ZAndU thol;            ///< Thol 2016 at T_0
    ZAndU kolafa;          ///< Kolafa and Nezbeda 1994 at T_0

    /// (simulation with what its cutoff misses - Thol 2016)/standard error
    [[nodiscard]] ZAndU z_scores() const;

    /// Whether nothing better can be expected of more steps.
    [[nodiscard]] bool precise(const ReproductionLength& length) const;
};

/// What a tail with g = 1 beyond the cutoff misses of energy and compressibility factor, to first order:
///
///     dU = 2 pi rho * integral from rc of (g - 1) u r^2 dr,   dZ = (2 pi rho/(3 T)) * integral of (g - 1) w r^4 dr,  w
///     = -u'/r
///
/// of Lennard-Jones, as far as g(r) is known (half the box). Simulated values and these make those of the full
/// potential.
/// @param r, g  middles of bins of equal width [sigma], and g(r) there
/// @pre r.size() == g.size() >= 2
[[nodiscard]] ZAndU cutoff_bias(const std::vector<double>& r, const std::vector<double>& g, double density,
                                double temperature, double cutoff);

/// Read what a row's run has left.
/// @throws DataError  its files are not there, or damaged
/// @throws PhysicsError  its temperature is one at which Thol's equation says nothing
[[nodiscard]] ReproducedRow evaluate_row(const VerletRow& row, const std::filesystem::path& directory);

/// Chi-square of the z-scores of rows that are sound, and the number of these scores: of Z and of U.
struct ChiSquare {
    double z;
    int z_count;
    double u;
    int u_count;
};
[[nodiscard]] ChiSquare chi_square(const std::vector<ReproducedRow>& rows);

}  // namespace ljmd
