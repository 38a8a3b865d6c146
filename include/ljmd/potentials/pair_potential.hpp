#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "ljmd/core/section.hpp"
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

/// Every truncated formula: what the pair sums are compiled for.
using AnyPair = decltype(detail::variant_of(std::declval<decltype(detail::all_pairs_of(AllFormulas{}))>()));

/// A formula with its truncation, chosen by name: the potential of a fluid.
class PairPotential {
  public:
    /// @param potential  [potential] after validation with `keys_for` of its type and truncation
    /// @pre cutoff > 0; for `switched` 0 < switch_start < cutoff
    static PairPotential from(const Section& potential);

    /// For programs that use the library without a deck: Lennard-Jones.
    /// @param truncation  "cut", "shifted", "force-shifted" or "switched"; else InputError
    static PairPotential lennard_jones(const std::string& truncation, const Cutoff& cutoff);

    /// The names that `type` and `truncation` take, and what the keys of each are.
    [[nodiscard]] static std::vector<std::string> formula_names();
    [[nodiscard]] static std::vector<std::string> truncation_names();
    [[nodiscard]] static std::string formula_meaning(const std::string& formula);
    [[nodiscard]] static std::vector<Key> formula_keys(const std::string& formula);
    [[nodiscard]] static std::vector<Key> truncation_keys(const std::string& truncation);
    /// True where a g = 1 tail correction has a meaning: `cut` and `switched`.
    [[nodiscard]] static bool takes_tail(const std::string& truncation);

    [[nodiscard]] const std::string& formula() const { return formula_; }
    [[nodiscard]] const std::string& truncation() const { return truncation_; }
    [[nodiscard]] const Cutoff& cutoff() const { return cutoff_; }

    /// The formula's own numbers by their keys in a deck, in reduced units.
    using Parameters = std::vector<std::pair<std::string, double>>;
    [[nodiscard]] const Parameters& parameters() const { return parameters_; }

    /// The formula as programs read it that are given potentials as text: u as a function of r and of the parameters by
    /// their names; what it uses is defined behind semicolons.
    [[nodiscard]] std::string expression() const;

    /// Call `visitor` with the concrete pair, for code that is compiled for each.
    template <class Visitor>
    decltype(auto) visit(Visitor&& visitor) const {
        return std::visit(std::forward<Visitor>(visitor), pair_);
    }

    /// Which of the types of AnyPair it is.
    [[nodiscard]] std::size_t index() const { return pair_.index(); }

    /// The truncated pair term at distance r [sigma]; zero at and beyond the cutoff.
    [[nodiscard]] PairTerm<double> operator()(double r) const;

    /// The formula itself, without truncation.
    [[nodiscard]] PairTerm<double> untruncated(double r) const;

    /// The integrals over what the truncation leaves out, for g(r) = 1 beyond the radius where it begins to differ from
    /// the formula: closed form where the formula has one, GSL quadrature elsewhere. For the shifted forms: beyond rc.
    [[nodiscard]] TailIntegrals tail() const;

    /// The same, always by quadrature.
    [[nodiscard]] TailIntegrals tail_by_quadrature() const;

  private:
    PairPotential(std::string formula, Parameters parameters, std::string truncation, const Cutoff& cutoff,
                  AnyPair pair, AnyPair bare);

    /// What `switched` takes away between switch_start and cutoff.
    [[nodiscard]] TailIntegrals switched_off() const;
    [[nodiscard]] TailIntegrals beyond_cutoff_by_quadrature() const;

    std::string formula_;
    Parameters parameters_;
    std::string truncation_;
    Cutoff cutoff_;
    AnyPair pair_;
    AnyPair bare_;  ///< the formula, as Cut
};

}  // namespace ljmd
