#pragma once

#include <cstdlib>
#include <string>
#include "catch.hpp"

#include "compare/openmm.hpp"
#include "io/files/process.hpp"

namespace ljmd::test {

/// The program that is LAMMPS here.
inline std::string lammps_name() {
    const char* named = std::getenv("LJMD_LAMMPS");
    return named != nullptr ? named : "lmp";
}

/// Whether a test can go on that needs another program: skipped without it, and with LJMD_REQUIRE_PEERS=1 in the
/// environment a failure.
inline bool peer_is_here(bool here, const std::string& what) {
    const char* required = std::getenv("LJMD_REQUIRE_PEERS");
    if (!here && required != nullptr && std::string(required) == "1") {
        FAIL("there is no " << what << ", and LJMD_REQUIRE_PEERS=1");
    }
    if (!here) {
        WARN("skipped: there is no " << what);
    }
    return here;
}

inline bool lammps_is_here() {
    return peer_is_here(find_program(lammps_name()).has_value(), "program '" + lammps_name() + "'");
}

inline bool openmm_is_here() {
    return peer_is_here(openmm_is_built_in(), "OpenMM in this ljmd");
}

}  // namespace ljmd::test
