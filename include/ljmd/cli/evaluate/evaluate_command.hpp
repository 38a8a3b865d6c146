#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// Options of `ljmd evaluate`.
struct EvaluateOptions {
    std::string path{};                   ///< a configuration, a trajectory, or the directory of a run
    std::string deck{};                   ///< empty: that of the run, or the options of the potential
    std::vector<std::string> settings{};  ///< arguments of --set, for a deck

    // The potential, where there is no deck.
    std::string potential{};                ///< formula; empty: lennard-jones
    std::vector<std::string> parameters{};  ///< "NAME=VALUE"
    std::string truncation{};
    std::optional<double> cutoff{};        ///< [sigma]
    std::optional<double> switch_start{};  ///< [sigma]
    std::string tail{};                    ///< "true", "false", or empty

    std::optional<Index> frame{};  ///< from 1; none: all
    std::string group{};           ///< particle group of an H5MD file; empty: the only one
    std::string xyz_comment{};     ///< keys missing from the comment lines of an extended XYZ file
    std::string out{};             ///< extended XYZ file or LAMMPS dump to write; empty: none
    int threads = 0;               ///< 0: OMP_NUM_THREADS, or 1
    bool force = false;
    bool json = false;
};

/// ljmd evaluate CONFIGURATION: energy, virial, pressure and forces of each frame of a file. Nothing is run.
/// @throws InputError, DataError and OutputRefused with what is wrong
void evaluate_command(const EvaluateOptions& options);

}  // namespace ljmd
