#include "engine/few_body_system.hpp"

namespace ljmd {

namespace {

Vec3 padded(const std::vector<double>& components) {
    Vec3 vector = Vec3::Zero();
    for (std::size_t k = 0; k < components.size(); ++k) {
        vector[static_cast<Index>(k)] = components[k];
    }
    return vector;
}

}  // namespace

State few_body_start(const std::vector<BodyStart>& bodies, const FewBodyForceOptions& force,
                     const Execution& execution) {
    State state(static_cast<Index>(bodies.size()), std::nullopt, execution);
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const auto i = static_cast<Index>(k);
        r.col(i) = padded(bodies[k].position);
        v.col(i) = padded(bodies[k].velocity);
        state.write_masses()[k] = force.inertia(bodies[k].mass);
    }
    return state;
}

FewBodySystem make_few_body_system(const FewBodySpec& spec, const Execution& execution) {
    const ChosenFewBodyForce force = chosen_few_body_force(spec.force);
    FewBodySystem system{few_body_start(spec.bodies, *force.options, execution),
                         static_cast<int>(spec.bodies.front().position.size()),
                         force,
                         force.options->make(),
                         {}};
    const FewBodyTarget target{system.state.count(), system.dimensions, system.force};
    for (const Choice& analysis : spec.analyses) {
        system.analyses.emplace_back(analysis.name, chosen_few_body_analysis(analysis).options->make(target));
    }
    return system;
}

}  // namespace ljmd
