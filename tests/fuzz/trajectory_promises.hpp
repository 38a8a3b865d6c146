#pragma once

#include "configuration_promises.hpp"
#include "io/formats/trajectory_reader.hpp"

namespace ljmd::fuzz {

/// Read a file as a trajectory, to its end or until something in it is wrong. Every frame is a configuration that can
/// be measured, of as many atoms as the first one.
inline void check_trajectory(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units) {
    try {
        const auto reader = open_trajectory(path, units);
        Frame frame;
        std::size_t atoms = 0;
        while (reader->next(frame)) {
            const Configuration& found = frame.configuration;
            atoms = reader->frames() == 1 ? found.positions.size() : atoms;
            require(found.positions.size() == atoms, "a frame has another number of atoms");
            require(!found.step || *found.step >= 0, "a step is negative");
            check_promises(found);
        }
    } catch (const DataError&) {
    }
}

}  // namespace ljmd::fuzz
