#pragma once

#include "execution/ranks.hpp"

namespace ljmd {

/// What the module for MPI offers: begin, and be one of the ranks. The caller owns it; its end is the end of MPI. Null
/// if MPI does not begin.
extern "C" Ranks* ljmd_join_ranks();

inline constexpr const char* mpi_module_function = "ljmd_join_ranks";

}  // namespace ljmd
