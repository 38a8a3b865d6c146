#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ljmd {

/// How far a printed number can be relied upon.
enum class Soundness {
    sound,
    suspect,    ///< every other source contradicts it: a misprint, or a lost correction
    metastable  ///< the fluid would freeze or separate, so that the number depends on how long one waits
};

/// How a printed number has come here; the journal itself was not at hand.
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
    double temperature;                             ///< what the run turned out to have
    std::optional<Printed> compressibility_factor;  ///< Z = p/(rho T)
    std::optional<Printed> potential_energy;        ///< U/N
    std::string remark;                             ///< what is known to be wrong with it; empty: nothing
};

/// All rows, in the order of the journal: falling density.
[[nodiscard]] const std::vector<VerletRow>& verlet1967_table();

}  // namespace ljmd
