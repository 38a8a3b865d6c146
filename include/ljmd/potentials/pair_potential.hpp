#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "ljmd/potentials/formula_list.hpp"  // generated: one entry for every header in potentials/formulas/
#include "ljmd/potentials/pair_term.hpp"
#include "ljmd/potentials/truncation.hpp"

namespace ljmd {

namespace detail {

template <class Formula>
using Truncations = std::tuple<Cut<Formula>, Shifted<Formula>, ForceShifted<Formula>, Switched<Formula>>;

template <class... Formulas>
auto all_pairs_of(FormulaList<Formulas...>) -> decltype(std::tuple_cat(std::declval<Truncations<Formulas>>()...));

template <class... Pairs>
auto variant_of(const std::tuple<Pairs...>&) -> std::variant<Pairs...>;

}  // namespace detail

/// Every formula with every truncation: the types that pair sums are compiled for.
using AnyPair = decltype(detail::variant_of(std::declval<decltype(detail::all_pairs_of(AllFormulas{}))>()));

/// Pair potential of a fluid: a formula with a truncation, both chosen by name.
class PairPotential {
  public:
    /// Parameters of the formula by their keys in a deck, in reduced units.
    using Parameters = std::vector<std::pair<std::string, double>>;

    /// @param formula     one of formula_names(); else ContractViolation
    /// @param truncation  "cut", "shifted", "force-shifted" or "switched"; else InputError
    /// @param cutoff      radius > 0; for `switched` 0 < switch_start < radius
    /// @param parameters  all that formula_keys() names, in their ranges; else ContractViolation
    static PairPotential make(const std::string& formula, const std::string& truncation, const Cutoff& cutoff,
                              const Parameters& parameters);

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

    [[nodiscard]] const std::string& formula() const { return formula_; }
    [[nodiscard]] const std::string& truncation() const { return truncation_; }
    [[nodiscard]] const Cutoff& cutoff() const { return cutoff_; }

    [[nodiscard]] const Parameters& parameters() const { return parameters_; }

    /// The formula as text, for programs that read potentials as text: u as a function of r and of the parameters by
    /// name, with definitions after semicolons.
    [[nodiscard]] std::string expression() const;

    /// Call `visitor` with the pair potential as its own type, for code that is compiled for each type.
    template <class Visitor>
    decltype(auto) visit(Visitor&& visitor) const {
        return std::visit(std::forward<Visitor>(visitor), pair_);
    }

    /// Index of its type in AnyPair.
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

  private:
    PairPotential(std::string formula, Parameters parameters, std::string truncation, const Cutoff& cutoff,
                  AnyPair pair, AnyPair bare);

    /// Integrals over what `switched` removes between switch_start and cutoff.
    [[nodiscard]] TailIntegrals switched_off() const;
    [[nodiscard]] TailIntegrals beyond_cutoff_by_quadrature() const;

    std::string formula_;
    Parameters parameters_;
    std::string truncation_;
    Cutoff cutoff_;
    AnyPair pair_;
    AnyPair bare_;  ///< the formula without truncation, as Cut
};

}  // namespace ljmd
