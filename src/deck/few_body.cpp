#include "ljmd/deck/few_body.hpp"

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

State few_body_start(const std::vector<Section>& bodies, const FewBodyForceOptions& force) {
    State state(static_cast<Index>(bodies.size()));
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const auto i = static_cast<Index>(k);
        r.col(i) = padded(bodies[k].vector("position"));
        v.col(i) = padded(bodies[k].vector("velocity"));
        state.write_masses()[k] = force.inertia(bodies[k].number("mass"));
    }
    return state;
}

FewBodySystem make_few_body_system(const Deck& deck) {
    const ChosenFewBodyForce force = choose(find_few_body_force(deck.force().text("type")), deck.force());
    FewBodySystem system{few_body_start(deck.bodies(), *force.options),
                         static_cast<int>(deck.bodies().front().vector("position").size()),
                         force,
                         force.options->make(),
                         {}};
    const Section& analysis = deck.root.section("analysis");
    const FewBodyTarget target{system.state.count(), system.dimensions, system.force};
    for (const auto& method : all_few_body_analyses()) {
        if (analysis.has(method.name)) {
            const auto chosen = choose(method, analysis.section(method.name));
            system.analyses.emplace_back(method.name, chosen.options->make(target));
        }
    }
    return system;
}

}  // namespace ljmd
