#include "ljmd/potentials/pair_potential.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <optional>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/quadrature.hpp"

namespace ljmd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Call f.template operator()<Formula>() for each formula.
template <class F, class... Formulas>
void for_each_formula(FormulaList<Formulas...>, const F& f) {
    (f.template operator()<Formulas>(), ...);
}

/// Call f.template operator()<Truncation<Formula>>() for each truncation of a formula.
template <class Formula, class F>
void for_each_truncation(const F& f) {
    [&]<class... Pairs>(std::tuple<Pairs...>*) {
        (f.template operator()<Pairs>(), ...);
    }(static_cast<detail::Truncations<Formula>*>(nullptr));
}

template <class Formula>
AnyPair truncated(const Formula& formula, const std::string& truncation, const Cutoff& cutoff) {
    std::optional<AnyPair> result;
    for_each_truncation<Formula>([&]<class Pair>() {
        if (Pair::name == truncation) {
            result = Pair(formula, cutoff);
        }
    });
    if (!result) {
        throw InputError(fmt::format("unknown truncation '{}', allowed: {}", truncation,
                                     fmt::join(PairPotential::truncation_names(), ", ")));
    }
    return *result;
}

/// Any formula would do to list the truncations.
using SomeFormula = LennardJones;

template <class Formula>
std::vector<Key> keys_of_formula(Formula formula) {
    Description description;
    formula.describe(description);
    return description.keys();
}

template <class Formula>
Formula with_parameters(Formula formula, const PairPotential::Parameters& parameters) {
    Description description;
    formula.describe(description);
    if (description.keys().size() != parameters.size()) {
        throw ContractViolation(
            fmt::format("{} has {} parameters, not {}", Formula::name, description.keys().size(), parameters.size()));
    }
    for (const auto& [key, value] : parameters) {
        description.take(key, value);
    }
    return formula;
}

}  // namespace

PairPotential::PairPotential(std::string formula, Parameters parameters, std::string truncation, const Cutoff& cutoff,
                             AnyPair pair, AnyPair bare)
    : formula_(std::move(formula)),
      parameters_(std::move(parameters)),
      truncation_(std::move(truncation)),
      cutoff_(cutoff),
      pair_(pair),
      bare_(bare) {}

PairPotential PairPotential::make(const std::string& formula, const std::string& truncation, const Cutoff& cutoff,
                                  const Parameters& parameters) {
    std::optional<PairPotential> result;
    for_each_formula(AllFormulas{}, [&]<class Formula>() {
        if (Formula::name == formula) {
            const Formula made = with_parameters(Formula(), parameters);
            result = PairPotential(formula, parameters, truncation, cutoff, truncated(made, truncation, cutoff),
                                   Cut<Formula>(made, cutoff));
        }
    });
    if (!result) {
        throw ContractViolation(fmt::format("no potential is called '{}'", formula));
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
    for_each_truncation<SomeFormula>([&]<class Pair>() { names.emplace_back(Pair::name); });
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
    for_each_truncation<SomeFormula>([&]<class Pair>() {
        if (Pair::name == name) {
            Pair::describe(description, cutoff);
        }
    });
}

bool PairPotential::takes_tail(const std::string& name) {
    bool takes = false;
    for_each_truncation<SomeFormula>([&]<class Pair>() { takes = takes || (Pair::name == name && Pair::takes_tail); });
    return takes;
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
    const TailIntegrals outside = beyond_cutoff_by_quadrature();
    return {inside.energy + outside.energy, inside.virial + outside.virial};
}

TailIntegrals PairPotential::switched_off() const {
    const double start = visit([&]<class Pair>(const Pair&) { return Pair::changes_from(cutoff_); });
    if (!(start < cutoff_.radius)) {
        return {0.0, 0.0};
    }
    const auto missing_energy = [this](double r) { return (untruncated(r).u - (*this)(r).u) * r * r; };
    const auto missing_virial = [this](double r) { return (untruncated(r).w - (*this)(r).w) * r * r * r * r; };
    return {integrate(missing_energy, start, cutoff_.radius), integrate(missing_virial, start, cutoff_.radius)};
}

TailIntegrals PairPotential::beyond_cutoff_by_quadrature() const {
    return {integrate([this](double r) { return untruncated(r).u * r * r; }, cutoff_.radius, infinity),
            integrate([this](double r) { return untruncated(r).w * r * r * r * r; }, cutoff_.radius, infinity)};
}

}  // namespace ljmd
