#include "deck/run_plan.hpp"

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

void require(bool met, const std::string& otherwise) {
    if (!met) {
        throw InputError(otherwise);
    }
}

}  // namespace

std::vector<Stage>& RunPlan::stages() {
    return std::visit([](auto& of_kind) -> std::vector<Stage>& { return of_kind.stages; }, spec);
}

const std::vector<Stage>& RunPlan::stages() const {
    return std::visit([](const auto& of_kind) -> const std::vector<Stage>& { return of_kind.stages; }, spec);
}

Index RunPlan::sample_every() const {
    return std::visit([](const auto& of_kind) { return of_kind.sample_every; }, spec);
}

const std::optional<SubstanceUnits>& RunPlan::units() const {
    static const std::optional<SubstanceUnits> none;
    const auto* fluid = std::get_if<FluidSpec>(&spec);
    return fluid != nullptr ? fluid->units : none;
}

std::string kind_name(const RunPlan& plan) {
    return plan.is_fluid() ? "fluid" : "few-body";
}

void require_fluid(const RunPlan& plan, const std::string& otherwise) {
    require(plan.is_fluid(), otherwise);
}

void require_few_bodies(const RunPlan& plan, const std::string& otherwise) {
    require(!plan.is_fluid(), otherwise);
}

FluidSpec fluid_spec(const RunPlan& plan) {
    FluidSpec spec = std::get<FluidSpec>(plan.spec);
    if (plan.given.potential) {
        spec.potential = plan.given.potential->known();
    }
    return spec;
}

}  // namespace ljmd
