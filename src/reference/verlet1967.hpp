#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ljmd {

/// Reliability of a printed number.
enum class Soundness {
    sound,
    suspect,    ///< contradicted by every other source: a misprint, or a forgotten correction
    metastable  ///< the fluid would freeze or separate, so the number depends on the length of the run
};

/// Source of a printed number. The journal itself was not available.
enum class Provenance { two_reprints, one_reprint, recalled };

/// A number of the table.
struct Printed {
    double value;
    Soundness soundness;
    Provenance provenance;
};

/// A row of the table of L. Verlet (1967), Phys. Rev. 159, 98, doi:10.1103/PhysRev.159.98: 864 Lennard-Jones atoms, cut
/// at 2.5 sigma, with tail corrections; reduced units.
struct VerletRow {
    double density;
    double temperature;                             ///< result of the run
    std::optional<Printed> compressibility_factor;  ///< Z = p/(rho T)
    std::optional<Printed> potential_energy;        ///< U/N
    std::string remark;                             ///< known mistakes in the row; may be empty
};

/// All rows in the order of the journal, by decreasing density.
[[nodiscard]] const std::vector<VerletRow>& verlet1967_table();

}  // namespace ljmd
