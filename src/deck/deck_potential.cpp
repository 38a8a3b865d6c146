#include "ljmd/deck/deck_potential.hpp"

namespace ljmd {

PairPotential pair_potential_of(const Section& potential) {
    const std::string& formula = potential.text("type");
    const std::string& truncation = potential.text("truncation");
    Cutoff cutoff{potential.number("cutoff"), 0.0};
    for (const Key& key : PairPotential::truncation_keys(truncation)) {
        if (key.name == "switch_start") {
            cutoff.switch_start = potential.number(key.name);
        }
    }
    PairPotential::Parameters parameters;
    for (const Key& key : PairPotential::formula_keys(formula)) {
        parameters.emplace_back(key.name, potential.number(key.name));
    }
    return PairPotential::make(formula, truncation, cutoff, parameters);
}

}  // namespace ljmd
