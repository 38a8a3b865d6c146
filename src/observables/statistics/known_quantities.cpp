#include "observables/statistics/known_quantities.hpp"

#include <algorithm>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

namespace {

/// Columns and results that are of no analysis, and of no sample of a fluid.
constexpr std::array<KnownQuantity, 17> others{{{"time", "t", "tau"},
                                                {"conserved_energy", "E/N - Q/N", "epsilon"},
                                                {"external_energy", "U_ext/N", "epsilon"},
                                                {"compressibility_factor", "Z", ""},
                                                {"heat_capacity_cv", "c_v", "k_B"},
                                                {"order_parameter", "order", ""},
                                                {"edge_x", "L_x", "sigma"},
                                                {"edge_y", "L_y", "sigma"},
                                                {"edge_z", "L_z", "sigma"},
                                                {"step", "step", ""},
                                                {"seconds", "wall time", "s"},
                                                {"Z", "Z", ""},
                                                {"U", "U/N", "epsilon"},
                                                {"rho", "rho", "sigma^-3"},
                                                {"T", "T", "epsilon/k_B"},
                                                {"length", "block length", "samples"},
                                                {"energy_change", "change of E/N", "epsilon"}}};

std::vector<KnownQuantity> all_quantities() {
    std::vector<KnownQuantity> known{sampled_quantities.begin(), sampled_quantities.end()};
    known.insert(known.end(), others.begin(), others.end());
    for (const AnalysisMethod& method : all_analyses()) {
        known.insert(known.end(), method.quantities.begin(), method.quantities.end());
    }
    return known;
}

}  // namespace

const KnownQuantity* find_quantity(std::string_view name) {
    static const std::vector<KnownQuantity> known = all_quantities();
    const auto found = std::ranges::find(known, name, &KnownQuantity::name);
    return found == known.end() ? nullptr : &*found;
}

ObservableAverage average_of(std::string_view name, const std::optional<Estimate>& estimate,
                             const std::string& remark) {
    const KnownQuantity* known = find_quantity(name);
    if (known == nullptr) {
        throw ContractViolation(std::string(name) + " is no known quantity");
    }
    const std::string unit = known->unit;
    return {known->name, known->symbol, unit.empty() ? "1" : unit, estimate, remark};
}

std::string symbol_of(std::string_view observable) {
    const KnownQuantity* found = find_quantity(observable);
    return found == nullptr ? "" : found->symbol;
}

}  // namespace ljmd
