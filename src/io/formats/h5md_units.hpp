#pragma once

#include <optional>
#include <string>

#include "io/formats/unit_scale.hpp"
#include "io/hdf5/hdf5_input.hpp"
#include "ljmd/detail/options/units.hpp"

namespace ljmd {

/// The datasets of an H5MD file whose numbers have units. An empty or unknown name: there is no such dataset.
struct H5mdQuantities {
    std::string positions;
    std::string times;
    std::string velocities;
    std::string edges;
    std::string masses = {};
};

/// One reduced unit in the units of the file.
struct H5mdScale : UnitScale {
    double edges = 1.0;                ///< sigma in the unit of the box edges
    std::optional<double> mass = 1.0;  ///< unit of mass; nothing for masses without a unit in a file with units
};

/// Read the attributes `unit`: "nm", "ps", "nm ps-1", "Angstrom/fs", ... Positions, times and velocities all have one
/// or none has; without one the file is in reduced units. Edges without a unit have the positions' unit. Masses may
/// have a unit if the positions have one.
/// @param units  of the substance; needed for a file with units
/// @throws DataError
[[nodiscard]] H5mdScale h5md_scale(const Hdf5Input& file, const H5mdQuantities& quantities,
                                   const std::optional<SubstanceUnits>& units);

/// One reduced unit of force, epsilon/sigma, in the unit of the forces: "kJ mol-1 nm-1" or "kJ/(mol nm)", or none where
/// the positions have none.
/// @return nothing if there are no forces, or they are in another unit
[[nodiscard]] std::optional<double> h5md_force_scale(const Hdf5Input& file, const std::string& forces,
                                                     const std::string& positions,
                                                     const std::optional<SubstanceUnits>& units);

}  // namespace ljmd
