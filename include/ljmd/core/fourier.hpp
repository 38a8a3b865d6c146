#pragma once

#include <array>
#include <complex>
#include <memory>

#include "ljmd/core/aligned_vector.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Discrete transforms by FFTW, with its signs and without factors. Several threads may make and call them at a time: a
/// call changes nothing but the output. Input and output must be AlignedVectors, or begin at a multiple of 64 bytes.
/// The way a transform is computed is chosen without timing, so that a repeated run has the same bits.
/// Source: Frigo and Johnson (2005), doi:10.1109/JPROC.2004.840301

/// The smallest even number with no prime factor above 7 that is at least n: lengths that transforms are fast for.
/// @throws ContractViolation if n < 1
[[nodiscard]] Index fast_length(Index n);

namespace detail {
struct FourierPlan;
struct DestroyFourierPlan {
    void operator()(FourierPlan* plan) const;
};
using OwnedFourierPlan = std::unique_ptr<FourierPlan, DestroyFourierPlan>;
}  // namespace detail

/// X_k = sum_j x_j exp(-2 pi i j k/n), k = 0 ... n/2, of `batch` real series that lie one behind the other, input n
/// numbers apart and output n/2 + 1 numbers apart.
class RealTransform {
  public:
    /// @throws ContractViolation unless n is even and positive and batch is positive
    explicit RealTransform(Index n, Index batch = 1);
    [[nodiscard]] Index length() const { return length_; }
    void operator()(AlignedVector<double>& x, AlignedVector<std::complex<double>>& transformed) const;

  private:
    Index length_;
    detail::OwnedFourierPlan plan_;
};

/// x_j = sum over all k of X_k exp(2 pi i j k/n) of a Hermitian X, of which k = 0 ... n/2 are given: n times the
/// inverse of RealTransform. X is lost.
class InverseRealTransform {
  public:
    /// @throws ContractViolation unless n is even and positive
    explicit InverseRealTransform(Index n);
    void operator()(AlignedVector<std::complex<double>>& transformed, AlignedVector<double>& x) const;

  private:
    detail::OwnedFourierPlan plan_;
};

/// X_k = sum_j x_j exp(-2 pi i (j_0 k_0/n_0 + ...)) on a grid of n_0 * n_1 * n_2 real numbers, the last index fastest;
/// the last index of X goes from 0 to n_2/2.
class GridTransform {
  public:
    /// @throws ContractViolation unless all lengths are even and positive
    explicit GridTransform(const std::array<Index, 3>& lengths);
    void operator()(AlignedVector<double>& x, AlignedVector<std::complex<double>>& transformed) const;

  private:
    detail::OwnedFourierPlan plan_;
};

/// Y_k = 2 sum_{j=0}^{n-1} x_j sin(pi (j + 1/2)(k + 1)/n), k = 0 ... n - 1: an odd function that is known in the
/// middles of n intervals.
class SineTransform {
  public:
    /// @throws ContractViolation if n < 1
    explicit SineTransform(Index n);
    void operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const;

  private:
    detail::OwnedFourierPlan plan_;
};

/// Y_k = x_0 + (-1)^k x_{n-1} + 2 sum_{j=1}^{n-2} x_j cos(pi j k/(n - 1)), k = 0 ... n - 1: an even function that is
/// known at the ends of n - 1 intervals; Y is what the trapezoidal rule makes of its cosine integrals, but for a
/// factor.
class CosineTransform {
  public:
    /// @throws ContractViolation if n < 2
    explicit CosineTransform(Index n);
    void operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const;

  private:
    detail::OwnedFourierPlan plan_;
};

}  // namespace ljmd
