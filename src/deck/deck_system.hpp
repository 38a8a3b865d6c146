#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "deck/deck.hpp"
#include "deck/fluid.hpp"
#include "engine/few_body_system.hpp"
#include "engine/fluid_system.hpp"

namespace ljmd {

/// What a run of a deck moves and measures.
using AnySystem = std::variant<FluidSystem, FewBodySystem>;

/// The system of a deck at its start.
/// @param start  of a fluid, from find_start(); none for few bodies
/// @param warn   receives one line per remark for the user
/// @param external  of the calling program, acts beside the deck's forces; null: none
/// @throws DataError, PhysicsError as make_fluid(); InputError if the deck does not go with the external force
[[nodiscard]] AnySystem make_system(const Deck& deck, std::optional<Start> start, const Execution& execution,
                                    const std::function<void(const std::string&)>& warn,
                                    const std::shared_ptr<ExternalForce>& external = nullptr);

/// The system of a run before a checkpoint is read into it.
/// @param edges  of the box; no matter for few bodies, which have none
/// @param external  as in make_system()
[[nodiscard]] AnySystem empty_system(const RunPlan& plan, Index atoms, const Vec3& edges, const Execution& execution,
                                     const std::shared_ptr<ExternalForce>& external = nullptr);

/// Whether a system of the run can have a box with these edges, which say nothing about few bodies.
[[nodiscard]] bool is_possible_box(const RunPlan& plan, Index atoms, const Vec3& edges);

}  // namespace ljmd
