#include "deck/deck_system.hpp"

#include "engine/few_body_system.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

FluidSpec with(const std::shared_ptr<ExternalForce>& external, FluidSpec spec) {
    spec.external = external;
    for (const Mistake& mistake : external_force_mistakes(spec)) {
        throw InputError(in_words(mistake));
    }
    return spec;
}

void require_none(const std::shared_ptr<ExternalForce>& external) {
    if (external) {
        throw InputError("external forces are for fluids: this deck has few bodies");
    }
}

}  // namespace

AnySystem make_system(const Deck& deck, std::optional<Start> start, const Execution& execution,
                      const std::function<void(const std::string&)>& warn,
                      const std::shared_ptr<ExternalForce>& external) {
    if (start) {
        return make_fluid(with(external, fluid_spec(deck, std::move(*start))), execution, warn);
    }
    require_none(external);
    return make_few_body_system(deck.few_bodies(), execution);
}

AnySystem empty_system(const RunPlan& plan, Index atoms, const Vec3& edges, const Execution& execution,
                       const std::shared_ptr<ExternalForce>& external) {
    if (plan.is_fluid()) {
        return empty_fluid(with(external, fluid_spec(plan)), atoms, Box(edges), execution);
    }
    require_none(external);
    return make_few_body_system(plan.few_bodies(), execution);
}

bool is_possible_box(const RunPlan& plan, Index atoms, const Vec3& edges) {
    try {
        return !plan.is_fluid() || box_mistakes(std::get<FluidSpec>(plan.spec), atoms, Box(edges)).empty();
    } catch (const InputError&) {  // no box has these edges
        return false;
    }
}

}  // namespace ljmd
