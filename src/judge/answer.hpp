#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/formats/trajectory_reader.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// What an engine says of the configuration it was given. Each part may be missing.
struct PointAnswer {
    std::optional<double> potential_energy{};  ///< of all atoms, with the tail correction if the deck has one [epsilon]
    std::optional<double> kinetic_energy{};    ///< of all atoms [epsilon]
    std::optional<double> temperature{};       ///< [epsilon/k_B]
    std::optional<double> virial{};            ///< W = sum over pairs of r . f, without tail [epsilon]
    std::optional<double> pressure{};          ///< (2 K + W)/(3 V), with the tail if the deck has one [epsilon/sigma^3]
    std::vector<Vec3> forces{};                ///< on each atom, by id [epsilon/sigma]; empty: missing

    [[nodiscard]] bool is_empty() const {
        return !potential_energy && !kinetic_energy && !temperature && !virial && !pressure && forces.empty();
    }
};

/// The table of an engine's run: quantities as in PointAnswer, one entry for each step. A missing column is empty.
struct ThermoAnswer {
    std::vector<Index> steps;
    std::vector<double> potential_energy;
    std::vector<double> kinetic_energy;
    std::vector<double> temperature;
    std::vector<double> pressure;
    std::vector<double> volume;  ///< [sigma^3]
};

/// Where the numbers of a file end because the engine has lost its atoms.
struct Loss {
    std::string check;  ///< that fails: "frames.xyz: frame 4 (step 100) can be read"
    std::string words;  ///< a sentence about it
};

/// All that an engine has answered.
struct Answer {
    std::string engine;                         ///< how it calls itself; empty if it does not say
    std::optional<Index> degrees_of_freedom{};  ///< of its thermostat, if it says so
    PointAnswer point;
    std::vector<Frame> frames;  ///< the first one, and those at judged steps; positions may be wrapped or not
    std::optional<ThermoAnswer> thermo{};
    std::vector<std::string> warnings;  ///< remarks on the files
    std::vector<Loss> losses{};         ///< the frames and rows from there on are left out
};

}  // namespace ljmd
