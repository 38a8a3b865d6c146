#include "engine/tables/potential_table.hpp"

#include "engine/mistakes/mistakes.hpp"

namespace ljmd {

namespace {

std::string meaning_of_formulas() {
    std::string meaning = "pair potential u(r)";
    for (const auto& name : PairPotential::formula_names()) {
        meaning += "; " + name + ": " + PairPotential::formula_meaning(name);
    }
    return meaning;
}

/// The keys of a formula, bound to its parameters.
Description description_of(const std::string& formula, PairPotential::Parameters& parameters) {
    const std::vector<Key> keys = PairPotential::formula_keys(formula);
    if (parameters.empty()) {
        for (const Key& key : keys) {
            parameters.emplace_back(key.name, 0.0);
        }
    }
    Description description;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        description.bind(keys[k], parameters[k].second);
    }
    return description;
}

}  // namespace

void PotentialTable::describe(TableDescription& description) {
    description.required_choice("type", PairPotential::formula_names(), type).meaning(meaning_of_formulas());
    description.required_number("cutoff", radius)
        .dimension(Dimension::length)
        .unit("sigma")
        .at_least(min_cutoff)
        .meaning("pairs closer than this interact; at most L/2");
    description.required_choice("truncation", PairPotential::truncation_names(), truncation)
        .meaning("what happens at the cutoff");
    description.flag("tail", tail)
        .optional("false for the shifted forms; must be given for cut and switched")
        .meaning("correct energy and pressure for what is cut off, with g(r) = 1; cut and switched only");
    for (const auto& name : PairPotential::formula_names()) {
        description.when("type", name, description_of(name, parameters[name]));
    }
    for (const auto& name : PairPotential::truncation_names()) {
        Description keys;
        PairPotential::describe_truncation(name, keys, *this);
        description.when("truncation", name, keys);
    }
}

PairPotential pair_potential_of(const PotentialTable& table) {
    return PairPotential::make(table.type, table.truncation, table, table.parameters.at(table.type));
}

PotentialTable potential_table(const FluidSpec& spec) {
    const PairPotential& potential = spec.potential;
    PotentialTable table;
    static_cast<Cutoff&>(table) = potential.cutoff();
    table.type = potential.formula();
    table.truncation = potential.truncation();
    table.tail = PairPotential::takes_tail(table.truncation) ? std::optional(spec.has_tail()) : std::nullopt;
    table.parameters[table.type] = potential.parameters();
    return table;
}

}  // namespace ljmd
