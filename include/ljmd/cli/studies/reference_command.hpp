#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/study/reference/reference_setup.hpp"

namespace ljmd {

/// Options of `ljmd reference`.
struct ReferenceOptions {
    ReferenceRequest request{};             ///< without properties and errors
    std::vector<std::string> properties{};  ///< names, aliases, "all"; empty: energy and pressure
    std::vector<std::string> errors{};      ///< "NAME=NUMBER"
    std::string out{};                      ///< directory; empty: runs/reference-T...
    int jobs = 0;                           ///< replicas at a time; 0: the number of processors
    bool force = false;
    bool quiet = false;
    bool json = false;
};

/// ljmd reference: values of the Lennard-Jones fluid at a state, to errors that are asked for. Pilot runs find when the
/// fluid is in equilibrium, canonical replicas are made longer until the errors are reached, and replicas at constant
/// energy measure transport. Finished runs are kept, interrupted ones are resumed.
void reference_command(const ReferenceOptions& options);

}  // namespace ljmd
