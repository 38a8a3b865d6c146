#pragma once

#include <optional>
#include <string>

#include "../hdf5/hdf5_input.hpp"
#include "ljmd/core/units.hpp"
#include "unit_scale.hpp"

namespace ljmd {

/// The datasets of an H5MD file whose numbers have units. An empty name, or one that is not in the file: there is none.
struct H5mdQuantities {
    std::string positions;
    std::string times;
    std::string velocities;
    std::string edges;
    std::string masses = {};
};

/// One reduced unit in those of the file.
struct H5mdScale : UnitScale {
    double edges = 1.0;                ///< of sigma
    std::optional<double> mass = 1.0;  ///< of m; nothing for masses without a unit in a file with units
};

/// What the attributes `unit` say: "nm", "ps", "nm ps-1", "Angstrom/fs", ... Positions, times and velocities have one
/// all or none; without, the file is in reduced units. Edges without one have that of the positions.
/// Masses may have one where the positions have.
/// @param units  of the substance; needed for a file with units
/// @throws DataError
[[nodiscard]] H5mdScale h5md_scale(const Hdf5Input& file, const H5mdQuantities& quantities,
                                   const std::optional<SubstanceUnits>& units);

}  // namespace ljmd
