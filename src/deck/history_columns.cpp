#include "deck/history_columns.hpp"

#include <algorithm>

#include "integrators/barostat.hpp"

namespace ljmd {

ThermoColumns thermo_columns(const RunPlan& plan, bool order_parameter, const ExternalForce* external) {
    const auto any = [&](const auto& wanted) { return std::ranges::any_of(plan.stages(), wanted); };
    return {{.density = any([](const Stage& stage) { return stage.barostat.has_value(); }),
             .edges = any([](const Stage& stage) {
                 return stage.barostat && find_barostat(stage.barostat->name).changes_shape;
             }),
             .external_energy = external != nullptr && external->has_energy(),
             .conserved_energy =
                 any([external](const Stage& stage) { return stage.thermostat && conserves_energy(stage, external); }),
             .order_parameter = order_parameter},
            plan.units()};
}

TrajectoryColumns trajectory_columns(const RunPlan& plan, const FewBodySystem& system) {
    return {system.state.count(), system.dimensions, plan.trajectory && plan.trajectory->accelerations,
            system.force.plugin.has_polar_angle};
}

}  // namespace ljmd
