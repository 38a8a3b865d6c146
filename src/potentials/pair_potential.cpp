#include "ljmd/potentials/pair_potential.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "core/quadrature.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/section.hpp"

namespace ljmd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Call f.template operator()<Formula>() for each formula.
template <class F, class... Formulas>
void for_each_formula(FormulaList<Formulas...>, const F& f) {
    (f.template operator()<Formulas>(), ...);
}

/// Any formula would do to list the truncations.
using SomeFormula = LennardJones;

/// Whether a truncation has a trait, which is told by its type. False for unknown names.
template <class Trait>
bool holds_for(const std::string& truncation, const Trait& trait) {
    bool holds = false;
    detail::for_each_truncation<SomeFormula>([&](const auto* type) {
        holds = holds || (detail::Pointee<decltype(type)>::name == truncation && trait(type));
    });
    return holds;
}

template <class Formula>
std::vector<Key> keys_of_formula(Formula formula) {
    Description description;
    formula.describe(description);
    return description.keys();
}

template <class Formula>
Formula with_parameters(Formula formula, const PairPotential::Parameters& parameters) {
    const Settings settings(parameters.begin(), parameters.end());
    static_cast<void>(checked_settings(std::string(Formula::name), keys_of_formula(formula), settings));
    Description description;
    formula.describe(description);
    for (const auto& [key, value] : settings) {
        description.take(key, value);
    }
    return formula;
}

}  // namespace

PairPotential::PairPotential(std::string formula, Parameters parameters, std::string truncation, const Cutoff& cutoff,
                             double changes_from, Pair pair, Pair bare)
    : formula_(std::move(formula)),
      parameters_(std::move(parameters)),
      truncation_(std::move(truncation)),
      cutoff_(cutoff),
      changes_from_(changes_from),
      pair_(std::move(pair)),
      bare_(std::move(bare)) {}

void PairPotential::check_truncation(const std::string& truncation) {
    const std::vector<std::string> known = truncation_names();
    if (std::ranges::find(known, truncation) == known.end()) {
        throw InputError(fmt::format("unknown truncation '{}', allowed: {}", truncation, fmt::join(known, ", ")));
    }
}

void PairPotential::check_custom_name(const std::string& name) {
    const std::vector<std::string> known = formula_names();
    if (name.empty() || std::ranges::find(known, name) != known.end()) {
        throw InputError(
            fmt::format("a formula of one's own needs a name of its own, which is not empty and none of {}; found '{}'",
                        fmt::join(known, ", "), name));
    }
}

PairPotential PairPotential::make(const std::string& formula, const std::string& truncation, const Cutoff& cutoff,
                                  const Parameters& parameters) {
    check_truncation(truncation);
    std::optional<PairPotential> result;
    for_each_formula(AllFormulas{}, [&]<class Formula>() {
        if (Formula::name == formula) {
            const Formula made = with_parameters(Formula(), parameters);
            detail::for_each_truncation<Formula>([&](const auto* type) {
                using Truncated = detail::Pointee<decltype(type)>;
                if (Truncated::name == truncation) {
                    result = PairPotential(formula, parameters, truncation, cutoff, Truncated::changes_from(cutoff),
                                           Truncated(made, cutoff), Cut<Formula>(made, cutoff));
                }
            });
        }
    });
    if (!result) {
        throw InputError(fmt::format("unknown potential '{}', allowed: {}", formula, fmt::join(formula_names(), ", ")));
    }
    return *result;
}

PairPotential PairPotential::lennard_jones(const std::string& truncation, const Cutoff& cutoff) {
    return make(std::string(LennardJones::name), truncation, cutoff, {});
}

std::vector<std::string> PairPotential::formula_names() {
    std::vector<std::string> names;
    for_each_formula(AllFormulas{}, [&]<class Formula>() { names.emplace_back(Formula::name); });
    return names;
}

std::vector<std::string> PairPotential::truncation_names() {
    std::vector<std::string> names;
    detail::for_each_truncation<SomeFormula>(
        [&](const auto* type) { names.emplace_back(detail::Pointee<decltype(type)>::name); });
    return names;
}

std::string PairPotential::formula_meaning(const std::string& name) {
    std::string meaning;
    for_each_formula(AllFormulas{}, [&]<class Formula>() {
        if (Formula::name == name) {
            meaning = Formula::meaning;
        }
    });
    return meaning;
}

std::string PairPotential::expression() const {
    std::string expression;
    for_each_formula(AllFormulas{}, [&]<class Formula>() {
        if (Formula::name == formula_) {
            expression = Formula::expression;
        }
    });
    return expression;
}

std::vector<Key> PairPotential::formula_keys(const std::string& name) {
    std::vector<Key> keys;
    for_each_formula(AllFormulas{}, [&]<class Formula>() {
        if (Formula::name == name) {
            keys = keys_of_formula(Formula());
        }
    });
    return keys;
}

void PairPotential::describe_truncation(const std::string& name, Description& description, Cutoff& cutoff) {
    detail::for_each_truncation<SomeFormula>([&](const auto* type) {
        using Truncated = detail::Pointee<decltype(type)>;
        if (Truncated::name == name) {
            Truncated::describe(description, cutoff);
        }
    });
}

bool PairPotential::takes_tail(const std::string& truncation) {
    return holds_for(truncation, []<class Truncated>(const Truncated*) { return Truncated::takes_tail; });
}

bool PairPotential::takes_switch_start(const std::string& truncation) {
    return holds_for(truncation, []<class Truncated>(const Truncated*) { return Truncated::takes_switch_start; });
}

bool PairPotential::energy_jumps(const std::string& truncation) {
    return holds_for(truncation, []<class Truncated>(const Truncated*) { return Truncated::energy_jumps; });
}

PairTerm<double> PairPotential::operator()(double r) const {
    if (!(r < cutoff_.radius)) {
        return {0.0, 0.0};
    }
    return visit([r](const auto& pair) { return pair_term(pair, r * r); });
}

PairTerm<double> PairPotential::untruncated(double r) const {
    return std::visit([r](const auto& formula) { return pair_term(formula, r * r); }, bare_);
}

TailIntegrals PairPotential::tail() const {
    return std::visit(
        [this](const auto& bare) -> TailIntegrals {
            if constexpr (requires { bare.formula().tail(1.0); }) {
                const TailIntegrals inside = switched_off();
                const TailIntegrals outside = bare.formula().tail(cutoff_.radius);
                return {inside.energy + outside.energy, inside.virial + outside.virial};
            } else {
                return tail_by_quadrature();
            }
        },
        bare_);
}

TailIntegrals PairPotential::tail_by_quadrature() const {
    const TailIntegrals inside = switched_off();
    const TailIntegrals outside = formula_beyond(cutoff_.radius);
    return {inside.energy + outside.energy, inside.virial + outside.virial};
}

TailIntegrals PairPotential::switched_off() const {
    if (!(changes_from_ < cutoff_.radius)) {
        return {0.0, 0.0};
    }
    const auto missing_energy = [this](double r) { return (untruncated(r).u - (*this)(r).u) * r * r; };
    const auto missing_virial = [this](double r) { return (untruncated(r).w - (*this)(r).w) * r * r * r * r; };
    return {integrate(missing_energy, changes_from_, cutoff_.radius),
            integrate(missing_virial, changes_from_, cutoff_.radius)};
}

TailIntegrals PairPotential::formula_beyond(double radius) const {
    return {integrate([this](double r) { return untruncated(r).u * r * r; }, radius, infinity),
            integrate([this](double r) { return untruncated(r).w * r * r * r * r; }, radius, infinity)};
}

}  // namespace ljmd
