#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "reference/verlet1967.hpp"

/// Recomputation of the rows of Verlet's table, one run per row.
namespace ljmd {

/// Lengths of the runs.
struct ReproductionLength {
    Index melt;
    Index equilibrate;
    Index production;  ///< steps of the first part, and of each part that is added while the errors are too large
    int max_parts;
    double largest_error_z;  ///< parts are added until the standard error of Z is at most this
    double largest_error_u;  ///< the same for U/N

    /// Errors of at most 0.02 in Z and 0.004 in U/N.
    static ReproductionLength full() { return {1000, 3000, 10'000, 20, 0.02, 0.004}; }

    /// The length of Verlet's own runs, 300 + 1200 steps, after a short melting stage.
    static ReproductionLength quick() { return {300, 300, 1200, 1, 0.0, 0.0}; }
};

/// The name of a row in file names: "rho0.8500-T0.786".
[[nodiscard]] std::string row_name(const VerletRow& row);

/// The deck of a row: 864 atoms start from an fcc lattice, are melted, brought to the temperature by rescaling, and run
/// at constant energy with Verlet's time step 0.032 (m sigma^2/48 epsilon)^(1/2); cutoff 2.5 with tail corrections.
[[nodiscard]] std::string row_deck(const VerletRow& row, const ReproductionLength& length);

/// A pair of values for Z and U/N.
struct ZAndU {
    double z;
    double u;
};

/// Results of a run for a row.
///
/// The temperature of a run at constant energy is a result. Z and U are converted to Verlet's temperature T_0, see
/// at_temperature().
struct ReproducedRow {
    VerletRow verlet;
    Index steps;           ///< of production
    Estimate temperature;  ///< <T>
    Estimate z;            ///< Z(T_0)
    Estimate u;            ///< U(T_0)
    ZAndU beyond_cutoff;   ///< correction to the tails because g(r) is not 1 beyond the cutoff: see cutoff_bias()
    ZAndU thol;            ///< Thol 2016 at T_0
    ZAndU kolafa;          ///< Kolafa and Nezbeda 1994 at T_0

    /// (simulation + beyond_cutoff - Thol 2016)/standard error
    [[nodiscard]] ZAndU z_scores() const;

    /// Whether no more steps are needed: the errors are small enough, or the maximum number of parts is reached.
    [[nodiscard]] bool precise(const ReproductionLength& length) const;
};

/// Correction to tails with g = 1 beyond the cutoff, for energy and compressibility factor, to first order:
///
///     dU = 2 pi rho * integral from rc of (g - 1) u r^2 dr,
///     dZ = (2 pi rho/(3 T)) * integral from rc of (g - 1) w r^4 dr,   w = -u'/r
///
/// for Lennard-Jones, as far as g(r) is known (half the box). Added to simulated values it gives the values of the full
/// potential.
/// @param r, g  midpoints of bins of equal width [sigma], and g(r) there
/// @pre r.size() == g.size() >= 2
[[nodiscard]] ZAndU cutoff_bias(const std::vector<double>& r, const std::vector<double>& g, double density,
                                double temperature, double cutoff);

/// Evaluate the files of a row's run.
/// @throws DataError  files are missing or damaged
/// @throws PhysicsError  Thol's equation is not valid at its temperature
[[nodiscard]] ReproducedRow evaluate_row(const VerletRow& row, const std::filesystem::path& directory);

/// Chi-square of the z-scores of sound rows, and the number of scores, for Z and for U.
struct ChiSquare {
    double z;
    int z_count;
    double u;
    int u_count;
};
[[nodiscard]] ChiSquare chi_square(const std::vector<ReproducedRow>& rows);

}  // namespace ljmd
