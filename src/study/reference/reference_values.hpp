#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/reference/canonical_series.hpp"
#include "study/reference/reference_setup.hpp"

namespace ljmd {

/// A property of the full Lennard-Jones fluid without limit of size, with what it is uncertain by.
struct ReferenceValue {
    std::string name;
    std::string symbol;
    std::string unit;
    std::optional<double> mean{};  ///< with both corrections; none: the remark says why
    double statistical_error;      ///< one standard deviation; NaN if unknown
    double systematic_error;       ///< of corrections and of what is not corrected, as a standard deviation; NaN where
                                   ///< it is not assessed
    double cutoff_correction = 0.0;                              ///< was added for the cutoff
    double size_correction = 0.0;                                ///< was added for the number of atoms
    double independent = 0.0;                                    ///< independent samples
    bool converged = true;                                       ///< false: the statistical error is a guess
    std::vector<std::pair<std::string, double>> by_equations{};  ///< names of equations of state, and their values
    std::string remark{};
    bool withheld = false;  ///< no length of the runs gives a value

    /// sqrt(statistical^2 + systematic^2); NaN if one is not known.
    [[nodiscard]] double total_error() const;
};

/// Finished replicas of one deck.
struct ReplicaFolder {
    std::filesystem::path merged;             ///< directory with their merged results
    std::vector<std::filesystem::path> runs;  ///< their own directories
};

/// What canonical replicas have found: energy, pressure, compressibility factor, and what else the request has.
///
/// Energy and pressure are means of canonical_series(), merged (merged_mean()), with cutoff_energy and cutoff_pressure
/// added (CutoffCorrection), and less canonical_size_shift(). Statistical errors are as for until-error runs, e (1 +
/// 2/nu), with e of block averages. Systematic errors are the sum of squares of
///
/// - the cutoff: the second order of the response of the structure, which is a part 2 |c| rho S(0)/T of the first one
///   (p_tail = c rho^2; at least 0.05 is taken), and as much of the response as the potential beyond the counted radius
///   has of that beyond the cutoff; and what oscillations of g(r) of the height that is found in the last sigma before
///   the radius would add in the half period behind it;
/// - the size: the difference between the shifts by two equations of state.
///
/// Response functions follow from c_v, (dp/dT)_V and K_T, and so do their size shifts and systematic errors. Each of
/// the three is uncertain by its size shift, as above, and by the cutoff: K_T by ten times what the cutoff leaves
/// uncertain in the pressure, because the phase of the oscillations of g(r) depends on the density; (dp/dT)_V by 2/T
/// times that, and c_v by 2/T times what it leaves uncertain in the energy.
/// @throws DataError  files are missing or damaged
[[nodiscard]] std::vector<ReferenceValue> canonical_values(const ReferenceSetup& setup, const ReplicaFolder& canonical);

/// Diffusion without limit of size (Yeh and Hummer), viscosity, bulk viscosity and thermal conductivity, those that the
/// request has. @throws DataError
[[nodiscard]] std::vector<ReferenceValue> transport_values(const ReferenceSetup& setup, const ReplicaFolder& transport);

/// Total energy per atom at the temperature of the request, as canonical replicas have found it: of the potential with
/// cutoff and of N atoms at rest as a whole, for runs at constant energy.
[[nodiscard]] double found_total_energy(const ReferenceSetup& setup, const ReplicaFolder& canonical);

/// The density at the pressure of the request: the runs' density, plus (p_0 - p)/(dp/drho). The errors are the errors
/// of p over dp/drho. @pre the request has a pressure, and `pressure` a mean
[[nodiscard]] ReferenceValue density_at_pressure(const ReferenceSetup& setup, const ReferenceValue& pressure);

}  // namespace ljmd
