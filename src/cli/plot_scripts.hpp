#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ljmd {

/// Where a Python is looked for: names are searched for in PATH.
[[nodiscard]] std::vector<std::string> usual_pythons();

/// A Python 3.9 or later that has numpy and matplotlib: LJMD_PYTHON if that is set, else the first candidate that fits.
/// @throws InputError  there is none; the message says what to install
[[nodiscard]] std::filesystem::path python_for_plots(const std::vector<std::string>& candidates = usual_pythons());

/// The script that draws pictures, plot.py: of the installation that the program belongs to, else of its build.
/// @param program_directory  where the program is
/// @throws InputError  it is in neither place
[[nodiscard]] std::filesystem::path plot_script(const std::filesystem::path& program_directory);

}  // namespace ljmd
