#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/forces/force_field.hpp"

namespace ljmd {

/// A body, for the few-body forces.
struct Body {
    Index id;
    Index index;  ///< its index in memory
    double mass;
    Vec3 position;
};

/// The bodies of a state, sorted by id.
inline std::vector<Body> bodies_of(const State& state) {
    std::vector<Body> bodies(static_cast<std::size_t>(state.count()));
    const auto r = state.positions();
    for (Index i = 0; i < state.count(); ++i) {
        const Index id = state.ids()[static_cast<std::size_t>(i)];
        bodies[static_cast<std::size_t>(id)] = {id, i, state.masses()[static_cast<std::size_t>(i)], r.col(i)};
    }
    return bodies;
}

/// bodies_of(), checked. @throws PhysicsError naming the body if a position is not finite
inline std::vector<Body> finite_bodies_of(const State& state) {
    std::vector<Body> bodies = bodies_of(state);
    for (const Body& body : bodies) {
        const Vec3& r = body.position;
        if (!r.allFinite()) {
            throw PhysicsError(
                fmt::format("body {} is at ({}, {}, {}): the run has blown up. Is the time step too large?",
                            body.id + 1, r[0], r[1], r[2]));
        }
    }
    return bodies;
}

/// Energy and force of a body in an external field.
struct FieldTerm {
    double energy;
    Vec3 force;
};

/// The evaluation, or zeros if only forces were requested.
inline Evaluation asked_for(Request request, const Evaluation& evaluation) {
    return request.energy ? evaluation : Evaluation{};
}

/// Compute the forces on bodies that feel an external field and not each other.
/// @param term  FieldTerm(const Body&)
template <class Term>
Evaluation sum_over_bodies(State& state, Request request, const Term& term) {
    auto f = state.write_forces();
    Evaluation evaluation;
    for (const Body& body : finite_bodies_of(state)) {
        const FieldTerm here = term(body);
        f.col(body.index) = here.force;
        evaluation.potential_energy += here.energy;
        evaluation.virial += body.position * here.force.transpose();
    }
    return asked_for(request, evaluation);
}

}  // namespace ljmd
