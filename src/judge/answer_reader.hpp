#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "judge/answer.hpp"
#include "judge/exchange.hpp"

namespace ljmd {

/// Whether there is any file of an answer in a directory. @throws FileError
[[nodiscard]] bool has_answer(const std::filesystem::path& directory);

/// Read what an engine has left in a directory, each file if it is there and its part is judged:
///
///     point.json                          numbers, and forces as [[fx, fy, fz], ...] by id; for all parts the name of
///                                         the engine, and its degrees of freedom
///     point.xyz, .extxyz, .dump, .lammpsdump, .lammpstrj or .h5md     forces, in one frame
///     frames.xyz, ...                     frames of the trajectory, with steps, or with times
///     thermo.csv                          the table of the run
///
/// Of frames and rows those before the first one that is not finite, or has an atom 10^6 edges away, are read, and the
/// answer says so: they are of an engine that blew up.
///
/// @throws DataError  a file cannot be read, is cut off, begins with or otherwise holds a number that is not finite, is
/// of another number of atoms or another box; the text names the file, and what was expected
[[nodiscard]] Answer read_answer(const std::filesystem::path& directory, const Problem& problem);

}  // namespace ljmd
