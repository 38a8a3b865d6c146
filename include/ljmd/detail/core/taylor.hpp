#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace ljmd {

/// Third-degree Taylor polynomial of a function of two variables about a point (x0, y0):
///
///     f(x0 + h, y0 + k) = sum over i + j <= 3 of f_ij h^i k^j,    d^(i+j) f / dx^i dy^j = i! j! f_ij.
///
/// A formula that is a template over its number type, called with two of these, yields all derivatives up to the third,
/// exact except for round-off. Source: A. Griewank and A. Walther, Evaluating Derivatives (2008), chapter 13.
class Taylor {
  public:
    static constexpr std::size_t degree = 3;

    Taylor() = default;
    Taylor(double constant) { at(0, 0) = constant; }  // NOLINT(google-explicit-constructor): a number is a constant

    /// The first and the second variable at the point.
    static Taylor x(double x0) { return variable(x0, 1, 0); }
    static Taylor y(double y0) { return variable(y0, 0, 1); }

    [[nodiscard]] double value() const { return coefficients_[0][0]; }

    /// d^(i+j) f / dx^i dy^j. @pre i + j <= 3
    [[nodiscard]] double derivative(std::size_t i, std::size_t j) const {
        constexpr std::array<double, degree + 1> factorial{1.0, 1.0, 2.0, 6.0};
        return factorial[i] * factorial[j] * coefficients_[i][j];
    }

    Taylor& operator+=(const Taylor& other) { return combine(other, 1.0); }
    Taylor& operator-=(const Taylor& other) { return combine(other, -1.0); }
    Taylor& operator*=(const Taylor& other) { return *this = *this * other; }
    Taylor& operator/=(const Taylor& other) { return *this = *this / other; }

    friend Taylor operator+(Taylor a, const Taylor& b) { return a += b; }
    friend Taylor operator-(Taylor a, const Taylor& b) { return a -= b; }
    friend Taylor operator-(const Taylor& a) { return Taylor() -= a; }

    friend Taylor operator*(const Taylor& a, const Taylor& b) {
        Taylor product;
        each([&](std::size_t i, std::size_t j) {
            each([&](std::size_t k, std::size_t l) {
                if (i + j + k + l <= degree) {
                    product.at(i + k, j + l) += a.coefficients_[i][j] * b.coefficients_[k][l];
                }
            });
        });
        return product;
    }

    friend Taylor operator/(const Taylor& a, const Taylor& b) {
        const double inverse = 1.0 / b.value();
        const double inverse2 = inverse * inverse;
        return a * b.composed({inverse, -inverse2, inverse2 * inverse, -inverse2 * inverse2});
    }

    friend Taylor exp(const Taylor& a) {
        const double e = std::exp(a.value());
        return a.composed({e, e, e / 2.0, e / 6.0});
    }

    friend Taylor log(const Taylor& a) {
        const double inverse = 1.0 / a.value();
        return a.composed({std::log(a.value()), inverse, -inverse * inverse / 2.0, inverse * inverse * inverse / 3.0});
    }

    /// log(1 + a), accurate also for a near zero.
    friend Taylor log1p(const Taylor& a) {
        const double inverse = 1.0 / (1.0 + a.value());
        return a.composed(
            {std::log1p(a.value()), inverse, -inverse * inverse / 2.0, inverse * inverse * inverse / 3.0});
    }

    /// a^n for a real n. @pre a.value() > 0
    friend Taylor pow(const Taylor& a, double n) {
        const double inverse = 1.0 / a.value();
        const double p0 = std::pow(a.value(), n);
        const double p1 = n * p0 * inverse;
        const double p2 = (n - 1.0) * p1 * inverse / 2.0;
        return a.composed({p0, p1, p2, (n - 2.0) * p2 * inverse / 3.0});
    }

    /// a^n by multiplication, valid at zero, too. @pre n >= 0
    friend Taylor pow(const Taylor& a, int n) {
        Taylor product = 1.0;
        for (int factor = 0; factor < n; ++factor) {
            product *= a;
        }
        return product;
    }

  private:
    double& at(std::size_t i, std::size_t j) { return coefficients_[i][j]; }

    template <class Action>
    static void each(Action action) {
        for (std::size_t i = 0; i <= degree; ++i) {
            for (std::size_t j = 0; i + j <= degree; ++j) {
                action(i, j);
            }
        }
    }

    static Taylor variable(double value, std::size_t i, std::size_t j) {
        Taylor result = value;
        result.at(i, j) = 1.0;
        return result;
    }

    Taylor& combine(const Taylor& other, double sign) {
        each([&](std::size_t i, std::size_t j) { at(i, j) += sign * other.coefficients_[i][j]; });
        return *this;
    }

    /// g(f) for a function g with g(f0 + h) = g0 + g1 h + g2 h^2 + g3 h^3.
    [[nodiscard]] Taylor composed(const std::array<double, degree + 1>& g) const {
        Taylor h = *this;
        h.at(0, 0) = 0.0;
        return g[0] + h * (g[1] + h * (g[2] + h * g[3]));
    }

    std::array<std::array<double, degree + 1>, degree + 1> coefficients_{};
};

}  // namespace ljmd
