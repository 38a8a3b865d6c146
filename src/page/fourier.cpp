#include "observables/fourier.hpp"

#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "observables/fourier_lengths.hpp"

/// The transforms of fourier.hpp by the kissfft that comes with Eigen, in place of FFTW, which would be a large part of
/// the page. Their last digits are not those of FFTW.

namespace ljmd {

namespace {

using Complex = std::complex<double>;
using Line = std::vector<Complex>;

std::size_t size(Index n) {
    return static_cast<std::size_t>(n);
}

}  // namespace

namespace detail {

struct FourierPlan {
    std::array<Index, 3> lengths{};
    Index batch = 1;
    mutable Eigen::FFT<double> fft{Eigen::default_fft_impl<double>(), Eigen::FFT<double>::Unscaled};

    /// sum_j x_j exp(-2 pi i j k/n) for all k
    void forward(Line& x) const {
        const Line given = x;
        fft.fwd(x.data(), given.data(), static_cast<int>(x.size()));
    }
    /// sum_k X_k exp(2 pi i j k/n) for all j
    void backward(Line& x) const {
        const Line given = x;
        fft.inv(x.data(), given.data(), static_cast<int>(x.size()));
    }
};

void DestroyFourierPlan::operator()(FourierPlan* plan) const {
    delete plan;
}

}  // namespace detail

namespace {

detail::OwnedFourierPlan plan_for(std::array<Index, 3> lengths, Index batch = 1) {
    detail::OwnedFourierPlan plan(new detail::FourierPlan);
    plan->lengths = lengths;
    plan->batch = batch;
    return plan;
}

}  // namespace

RealTransform::RealTransform(Index n, Index batch)
    : length_(n), plan_(plan_for({even_length(n), 1, 1}, at_least(1, batch))) {}

void RealTransform::operator()(AlignedVector<double>& x, AlignedVector<Complex>& transformed) const {
    const Index kept = length_ / 2 + 1;
    Line line(size(length_));
    for (Index series = 0; series < plan_->batch; ++series) {
        for (Index j = 0; j < length_; ++j) {
            line[size(j)] = x[size(series * length_ + j)];
        }
        plan_->forward(line);
        for (Index k = 0; k < kept; ++k) {
            transformed[size(series * kept + k)] = line[size(k)];
        }
    }
}

InverseRealTransform::InverseRealTransform(Index n) : plan_(plan_for({even_length(n), 1, 1})) {}

void InverseRealTransform::operator()(AlignedVector<Complex>& transformed, AlignedVector<double>& x) const {
    const Index n = plan_->lengths[0];
    Line line(size(n));
    for (Index k = 0; k <= n / 2; ++k) {
        line[size(k)] = transformed[size(k)];
        line[size((n - k) % n)] = std::conj(transformed[size(k)]);
    }
    line[0] = line[0].real();
    line[size(n / 2)] = line[size(n / 2)].real();
    plan_->backward(line);
    for (Index j = 0; j < n; ++j) {
        x[size(j)] = line[size(j)].real();
    }
}

GridTransform::GridTransform(const std::array<Index, 3>& lengths)
    : plan_(plan_for({even_length(lengths[0]), even_length(lengths[1]), even_length(lengths[2])})) {}

void GridTransform::operator()(AlignedVector<double>& x, AlignedVector<Complex>& transformed) const {
    const auto& n = plan_->lengths;
    const Index kept = n[2] / 2 + 1;
    Line line(size(n[2]));
    for (Index row = 0; row < n[0] * n[1]; ++row) {
        for (Index j = 0; j < n[2]; ++j) {
            line[size(j)] = x[size(row * n[2] + j)];
        }
        plan_->forward(line);
        for (Index k = 0; k < kept; ++k) {
            transformed[size(row * kept + k)] = line[size(k)];
        }
    }
    // Along the other two axes: lines of `count` numbers, `stride` apart.
    const auto along = [&](Index first, Index count, Index stride) {
        line.resize(size(count));
        for (Index j = 0; j < count; ++j) {
            line[size(j)] = transformed[size(first + j * stride)];
        }
        plan_->forward(line);
        for (Index j = 0; j < count; ++j) {
            transformed[size(first + j * stride)] = line[size(j)];
        }
    };
    for (Index plane = 0; plane < n[0]; ++plane) {
        for (Index k = 0; k < kept; ++k) {
            along(plane * n[1] * kept + k, n[1], kept);
        }
    }
    for (Index k = 0; k < n[1] * kept; ++k) {
        along(k, n[0], n[1] * kept);
    }
}

SineTransform::SineTransform(Index n) : plan_(plan_for({at_least(1, n), 1, 1})) {}

void SineTransform::operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const {
    // The odd function on the midpoints of 2n intervals: its Fourier sum is -i Y_k exp(i pi (k + 1)/(2 n)).
    const Index n = plan_->lengths[0];
    Line line(size(2 * n));
    for (Index j = 0; j < n; ++j) {
        line[size(j)] = x[size(j)];
        line[size(2 * n - 1 - j)] = -x[size(j)];
    }
    plan_->forward(line);
    for (Index k = 0; k < n; ++k) {
        const double angle = std::numbers::pi * static_cast<double>(k + 1) / static_cast<double>(2 * n);
        transformed[size(k)] = -(line[size((k + 1) % (2 * n))] * std::polar(1.0, -angle)).imag();
    }
}

CosineTransform::CosineTransform(Index n) : plan_(plan_for({at_least(2, n), 1, 1})) {}

void CosineTransform::operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const {
    // The even function on the ends of 2 (n - 1) intervals.
    const Index n = plan_->lengths[0];
    const Index period = 2 * (n - 1);
    Line line(size(period));
    for (Index j = 0; j < period; ++j) {
        line[size(j)] = x[size(j < n ? j : period - j)];
    }
    plan_->forward(line);
    for (Index k = 0; k < n; ++k) {
        transformed[size(k)] = line[size(k % period)].real();
    }
}

}  // namespace ljmd
