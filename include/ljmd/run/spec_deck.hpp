#pragma once

#include <filesystem>
#include <string>

#include "ljmd/detail/deck/run_files.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

/// A specification as a deck: the text of a TOML file with which `ljmd run` makes the same run, to the last bit.
/// @param precision  of the pair sum, see Execution
/// @param start      where the deck finds the configuration that the specification starts from, if it does. The caller
/// puts it there
/// @throws InputError  the specification has mistakes, or says what no deck can: a formula of the calling program,
/// stages with seeds of their own, a seed of 2^63 or more
[[nodiscard]] std::string deck_text(const FluidSpec& spec, const RunFiles& files = {},
                                    Precision precision = Precision::double_precision,
                                    const std::filesystem::path& start = "start.xyz");

}  // namespace ljmd
