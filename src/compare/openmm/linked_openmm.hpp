#pragma once

#include "compare/openmm_module.hpp"

namespace ljmd {

/// See OpenmmModule.
[[nodiscard]] std::unique_ptr<Peer> linked_openmm_peer(OpenmmFluid fluid, const OpenmmOptions& options);
[[nodiscard]] OpenmmXml linked_openmm_xml(const OpenmmFluid& fluid, double time_step);

}  // namespace ljmd
