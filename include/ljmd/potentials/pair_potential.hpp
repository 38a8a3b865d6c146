#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "ljmd/detail/potentials/formula_list.hpp"  // generated: one entry for every header in potentials/formulas/
#include "ljmd/detail/potentials/pair_term.hpp"
#include "ljmd/detail/potentials/truncation.hpp"
#include "ljmd/potentials/custom_pair.hpp"

namespace ljmd {

namespace detail {

template <class Formula>
using Truncations = std::tuple<Cut<Formula>, Shifted<Formula>, ForceShifted<Formula>, Switched<Formula>>;

template <class Pointer>
using Pointee = std::remove_cv_t<std::remove_pointer_t<Pointer>>;

template <class F, class... Pairs>
void for_each_type(const F& f, const std::tuple<Pairs...>* /*types*/) {
    (f(static_cast<const Pairs*>(nullptr)), ...);
}

/// Call f with a null pointer to each truncation of a formula; its type says which.
template <class Formula, class F>
void for_each_truncation(const F& f) {
    for_each_type(f, static_cast<const Truncations<Formula>*>(nullptr));
}

template <class... Formulas>
auto all_pairs_of(FormulaList<Formulas...>) -> decltype(std::tuple_cat(std::declval<Truncations<Formulas>>()...));

template <class... Pairs>
auto variant_of(const std::tuple<Pairs...>&) -> std::variant<Pairs...>;

/// Of a formula that is known by a table; 0 for others, which do not have the function.
template <class Formula>
auto table_start(const Formula& formula, int /*preferred*/) -> decltype(formula.table_start()) {
    return formula.table_start();
}
template <class Formula>
double table_start(const Formula& /*formula*/, long /*else*/) {
    return 0.0;
}

template <class... Pairs>
auto with_custom(const std::variant<Pairs...>&) -> std::variant<Pairs..., CustomPair>;

}  // namespace detail

/// Every formula with every truncation: the types that kernels are compiled for.
using AnyPair = decltype(detail::variant_of(std::declval<decltype(detail::all_pairs_of(AllFormulas{}))>()));

/// Pair potential of a fluid: a formula with a truncation, both chosen by name, or a formula of the calling program
/// with one of these truncations.
class PairPotential {
  public:
    /// Parameters of the formula by their keys in a deck, in reduced units.
    using Parameters = std::vector<std::pair<std::string, double>>;

    /// @param formula     one of formula_names()
    /// @param truncation  "cut", "shifted", "force-shifted" or "switched"
    /// @param cutoff      radius > 0; for `switched` 0 < switch_start < radius (not checked here: see mistakes())
    /// @param parameters  all that formula_keys() names, in their ranges
    /// @throws InputError  an unknown name, a parameter that is missing, unknown, given twice or out of its range
    static PairPotential make(const std::string& formula, const std::string& truncation, const Cutoff& cutoff,
                              const Parameters& parameters);

    /// A formula of the calling program:
    ///
    ///     struct SoftSpheres {  // u = r^-12, w = -u'/r = 12 r^-14
    ///         PairTerm<double> operator()(const PairDistance<double>& d) const {
    ///             const double s6 = d.inverse_r2 * d.inverse_r2 * d.inverse_r2;
    ///             return {s6 * s6, 12.0 * s6 * s6 * d.inverse_r2};
    ///         }
    ///     };
    ///     spec.potential = PairPotential::custom("soft-spheres", SoftSpheres{}, "shifted", {.radius = 2.0});
    ///
    /// Forces, energies, pressures, tails, tables and checkpoints are as for a potential with a name of its own. Its
    /// sums are made by scalar code in double precision, in any pair search, by all threads; no deck can name it.
    /// @param name     for messages and checkpoints; not one of formula_names()
    /// @param formula  PairTerm<double> operator()(const PairDistance<double>&) const, the same whenever it is called,
    /// and called by several threads at once
    /// @param cutoff   as for make()
    /// @throws InputError  a name that is taken, an unknown truncation
    template <class Formula>
    static PairPotential custom(const std::string& name, const Formula& formula, const std::string& truncation,
                                const Cutoff& cutoff);

    /// Lennard-Jones, which has no parameters.
    static PairPotential lennard_jones(const std::string& truncation, const Cutoff& cutoff);

    /// Names that `type` and `truncation` take in a deck, and their keys.
    [[nodiscard]] static std::vector<std::string> formula_names();
    [[nodiscard]] static std::vector<std::string> truncation_names();
    [[nodiscard]] static std::string formula_meaning(const std::string& formula);
    [[nodiscard]] static std::vector<Key> formula_keys(const std::string& formula);
    /// The keys that a truncation has beside the cutoff's radius.
    static void describe_truncation(const std::string& truncation, Description& description, Cutoff& cutoff);
    /// True if a tail correction with g = 1 makes sense: for `cut` and `switched`.
    [[nodiscard]] static bool takes_tail(const std::string& truncation);

    /// Whether a truncation begins before the cutoff, at Cutoff::switch_start. False for unknown names.
    [[nodiscard]] static bool takes_switch_start(const std::string& truncation);

    /// Whether the energy of a pair jumps at the cutoff, by impulses that are missing in the forces. False for unknown
    /// names.
    [[nodiscard]] static bool energy_jumps(const std::string& truncation);

    [[nodiscard]] const std::string& formula() const { return formula_; }
    [[nodiscard]] const std::string& truncation() const { return truncation_; }
    [[nodiscard]] const Cutoff& cutoff() const { return cutoff_; }

    [[nodiscard]] const Parameters& parameters() const { return parameters_; }

    /// Whether it is a formula of the calling program: no kernel, no deck and no other program knows it.
    [[nodiscard]] bool is_custom() const { return std::holds_alternative<CustomPair>(pair_); }

    /// Radius from which the force differs from the formula's [sigma]; the cutoff unless it is switched off before.
    [[nodiscard]] double changes_from() const { return changes_from_; }

    /// Radius below which a potential that is known by a table has no values: the first distance of the table [sigma],
    /// see PairTable. 0 for all others, and for a table that begins there.
    [[nodiscard]] double starts_at() const { return starts_at_; }

    /// The formula as text, for programs that read potentials as text: u as a function of r and of the parameters by
    /// name, with definitions after semicolons. Empty for a formula of the calling program.
    [[nodiscard]] std::string expression() const;

    /// Call `visitor` with the pair potential as its own type, for code that is compiled for each type.
    template <class Visitor>
    decltype(auto) visit(Visitor&& visitor) const {
        return std::visit(std::forward<Visitor>(visitor), pair_);
    }

    /// Index of its type in AnyPair. @pre not is_custom()
    [[nodiscard]] std::size_t index() const { return pair_.index(); }

    /// Pair term of the truncated potential at distance r [sigma]; zero at and beyond the cutoff. @pre r > 0
    [[nodiscard]] PairTerm<double> operator()(double r) const;

    /// Pair term of the formula without truncation. @pre r > 0
    [[nodiscard]] PairTerm<double> untruncated(double r) const;

    /// Integrals over what the truncation removes, for g(r) = 1 beyond the radius at which the force begins to differ
    /// from the formula's; for the shifted truncations that is rc. In closed form if the formula has one, otherwise by
    /// GSL quadrature.
    [[nodiscard]] TailIntegrals tail() const;

    /// The same, always by quadrature.
    [[nodiscard]] TailIntegrals tail_by_quadrature() const;

    /// Integrals over the formula beyond a radius, for g(r) = 1 there, by quadrature. @pre radius > 0
    [[nodiscard]] TailIntegrals formula_beyond(double radius) const;

  private:
    using Pair = decltype(detail::with_custom(std::declval<AnyPair>()));

    PairPotential(std::string formula, Parameters parameters, std::string truncation, const Cutoff& cutoff,
                  double changes_from, Pair pair, Pair bare);

    // @throws InputError
    static void check_truncation(const std::string& truncation);
    static void check_custom_name(const std::string& name);

    /// Integrals over what `switched` removes between switch_start and cutoff.
    [[nodiscard]] TailIntegrals switched_off() const;

    std::string formula_;
    Parameters parameters_;
    std::string truncation_;
    Cutoff cutoff_;
    double changes_from_;
    double starts_at_ = 0.0;
    Pair pair_;
    Pair bare_;  ///< the formula without truncation, as Cut
};

template <class Formula>
PairPotential PairPotential::custom(const std::string& name, const Formula& formula, const std::string& truncation,
                                    const Cutoff& cutoff) {
    check_custom_name(name);
    check_truncation(truncation);
    const CustomFormula<Formula> bare{formula};
    std::optional<PairPotential> made;
    detail::for_each_truncation<CustomFormula<Formula>>([&](const auto* type) {
        using Truncated = detail::Pointee<decltype(type)>;
        if (Truncated::name == truncation) {
            made = PairPotential(name, {}, truncation, cutoff, Truncated::changes_from(cutoff),
                                 CustomPair::of(Truncated(bare, cutoff)), CustomPair::of(bare));
        }
    });
    made.value().starts_at_ = detail::table_start(formula, 0);
    return made.value();
}

}  // namespace ljmd
