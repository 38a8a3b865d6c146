#pragma once

#include <memory>
#include <utility>

#include "ljmd/detail/potentials/pair_term.hpp"

namespace ljmd {

/// A formula of the calling program, with what truncations ask of a formula.
template <class Formula>
struct CustomFormula {
    static constexpr bool takes_root = true;

    PairTerm<double> operator()(const PairDistance<double>& d) const { return formula(d); }

    Formula formula;
};

/// A pair potential whose type only the calling program knows. Each pair costs one virtual call.
class CustomPair {
  public:
    static constexpr bool takes_root = true;

    /// @param pair  PairTerm<double> operator()(const PairDistance<double>&) const, called by several threads at once
    template <class Pair>
    [[nodiscard]] static CustomPair of(Pair pair) {
        return CustomPair(std::make_shared<const TermOf<Pair>>(std::move(pair)));
    }

    PairTerm<double> operator()(const PairDistance<double>& d) const { return term_->at(d); }

  private:
    class Term {
      public:
        virtual ~Term() = default;
        [[nodiscard]] virtual PairTerm<double> at(const PairDistance<double>& d) const = 0;

      protected:
        Term() = default;
        Term(const Term&) = default;
        Term& operator=(const Term&) = default;
    };

    template <class Pair>
    class TermOf : public Term {
      public:
        explicit TermOf(Pair pair) : pair_(std::move(pair)) {}
        [[nodiscard]] PairTerm<double> at(const PairDistance<double>& d) const override { return pair_(d); }

      private:
        Pair pair_;
    };

    explicit CustomPair(std::shared_ptr<const Term> term) : term_(std::move(term)) {}

    std::shared_ptr<const Term> term_;
};

}  // namespace ljmd
