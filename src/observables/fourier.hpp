#pragma once

#include <array>
#include <complex>
#include <memory>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/aligned_vector.hpp"

namespace ljmd {

/// Discrete transforms by FFTW, with its signs and without normalisation. Several threads may create and call them at
/// the same time; a call changes only its output (and the input of InverseRealTransform). Input and output must be
/// AlignedVectors, or begin at a multiple of 64 bytes. Algorithms are chosen without timing, so that repeated runs have
/// the same bits.
/// Source: Frigo and Johnson (2005), doi:10.1109/JPROC.2004.840301

/// The smallest even number >= n without prime factors above 7, a length at which transforms are fast.
/// @throws ContractViolation if n < 1
[[nodiscard]] Index fast_length(Index n);

namespace detail {
struct FourierPlan;
struct DestroyFourierPlan {
    void operator()(FourierPlan* plan) const;
};
using OwnedFourierPlan = std::unique_ptr<FourierPlan, DestroyFourierPlan>;
}  // namespace detail

/// X_k = sum_j x_j exp(-2 pi i j k/n), k = 0 ... n/2, of `batch` real series. Series are consecutive, n numbers apart
/// in the input and n/2 + 1 apart in the output.
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

/// x_j = sum over all k of X_k exp(2 pi i j k/n) for Hermitian X, given for k = 0 ... n/2: n times the inverse of
/// RealTransform. Overwrites X.
class InverseRealTransform {
  public:
    /// @throws ContractViolation unless n is even and positive
    explicit InverseRealTransform(Index n);
    void operator()(AlignedVector<std::complex<double>>& transformed, AlignedVector<double>& x) const;

  private:
    detail::OwnedFourierPlan plan_;
};

/// X_k = sum_j x_j exp(-2 pi i (j_0 k_0/n_0 + ...)) of n_0 * n_1 * n_2 real numbers on a grid, last index fastest. The
/// last index of X runs from 0 to n_2/2.
class GridTransform {
  public:
    /// @throws ContractViolation unless all lengths are even and positive
    explicit GridTransform(const std::array<Index, 3>& lengths);
    void operator()(AlignedVector<double>& x, AlignedVector<std::complex<double>>& transformed) const;

  private:
    detail::OwnedFourierPlan plan_;
};

/// Y_k = 2 sum_{j=0}^{n-1} x_j sin(pi (j + 1/2)(k + 1)/n), k = 0 ... n - 1: sine transform of an odd function given at
/// the midpoints of n intervals.
class SineTransform {
  public:
    /// @throws ContractViolation if n < 1
    explicit SineTransform(Index n);
    void operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const;

  private:
    detail::OwnedFourierPlan plan_;
};

/// Y_k = x_0 + (-1)^k x_{n-1} + 2 sum_{j=1}^{n-2} x_j cos(pi j k/(n - 1)), k = 0 ... n - 1: cosine transform of an even
/// function given at the ends of n - 1 intervals. Up to a factor, Y is the cosine integral by the trapezoidal rule.
class CosineTransform {
  public:
    /// @throws ContractViolation if n < 2
    explicit CosineTransform(Index n);
    void operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const;

  private:
    detail::OwnedFourierPlan plan_;
};

}  // namespace ljmd
