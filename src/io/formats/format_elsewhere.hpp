#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ljmd {

/// What a file is whose format other programs read, DCD, XTC, TRR, NetCDF, GSD, GRO or PDB, and the lines of Python
/// that make a file of it which is read here. Known by its first bytes.
/// @param beginning  some hundred bytes
/// @return after the file's name: "is a trajectory in DCD ..."; empty for all other files
[[nodiscard]] std::string format_elsewhere(const std::filesystem::path& path, std::string_view beginning);

}  // namespace ljmd
