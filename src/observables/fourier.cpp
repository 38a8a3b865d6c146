#include "observables/fourier.hpp"

#include <fftw3.h>

#include <mutex>

#include "core/memory_at_hand.hpp"
#include "ljmd/core/errors.hpp"
#include "observables/fourier_lengths.hpp"

namespace ljmd {

namespace detail {

struct FourierPlan {
    fftw_plan plan;
};

namespace {

/// FFTW's planner uses shared tables; only the execution of plans is thread-safe (FFTW manual, "Thread safety").
std::lock_guard<std::mutex> one_planner_at_a_time() {
    static std::mutex planner;
    return std::lock_guard(planner);
}

}  // namespace

void DestroyFourierPlan::operator()(FourierPlan* plan) const {
    const auto alone = one_planner_at_a_time();
    fftw_destroy_plan(plan->plan);
    delete plan;
}

}  // namespace detail

namespace {

using Complex = std::complex<double>;

/// Memory that FFTW's planner needs besides the arrays. Its tables of methods and plans were measured at a few hundred
/// kilobytes.
constexpr std::size_t planner_memory = std::size_t{4} << 20;

fftw_complex* fftw(AlignedVector<Complex>& values) {
    return reinterpret_cast<fftw_complex*>(values.data());
}

/// Plan made by an FFTW planner with these arguments. Its arrays may be temporary: FFTW looks at their alignment, not
/// at their content.
template <typename Planner, typename... Arguments>
detail::OwnedFourierPlan planned(Planner planner, Arguments... arguments) {
    const auto alone = detail::one_planner_at_a_time();
    require_memory(planner_memory);
    fftw_plan plan = planner(arguments..., FFTW_ESTIMATE);
    if (plan == nullptr) {
        throw ContractViolation("FFTW has no transform of that kind");
    }
    return detail::OwnedFourierPlan(new detail::FourierPlan{plan});
}

detail::OwnedFourierPlan real_to_real(int n, fftw_r2r_kind kind) {
    AlignedVector<double> in(static_cast<std::size_t>(n));
    AlignedVector<double> out(static_cast<std::size_t>(n));
    return planned(fftw_plan_r2r_1d, n, in.data(), out.data(), kind);
}

}  // namespace

RealTransform::RealTransform(Index n, Index batch) : length_(n) {
    const int length = even_length(n);
    const int count = at_least(1, batch);
    AlignedVector<double> in(static_cast<std::size_t>(n * batch));
    AlignedVector<Complex> out(static_cast<std::size_t>((n / 2 + 1) * batch));
    plan_ = planned(fftw_plan_many_dft_r2c, 1, &length, count, in.data(), nullptr, 1, length, fftw(out), nullptr, 1,
                    length / 2 + 1);
}

void RealTransform::operator()(AlignedVector<double>& x, AlignedVector<Complex>& transformed) const {
    fftw_execute_dft_r2c(plan_->plan, x.data(), fftw(transformed));
}

InverseRealTransform::InverseRealTransform(Index n) {
    const int length = even_length(n);
    AlignedVector<Complex> in(static_cast<std::size_t>(n / 2 + 1));
    AlignedVector<double> out(static_cast<std::size_t>(n));
    plan_ = planned(fftw_plan_dft_c2r_1d, length, fftw(in), out.data());
}

void InverseRealTransform::operator()(AlignedVector<Complex>& transformed, AlignedVector<double>& x) const {
    fftw_execute_dft_c2r(plan_->plan, fftw(transformed), x.data());
}

GridTransform::GridTransform(const std::array<Index, 3>& lengths) {
    const std::array<int, 3> n{even_length(lengths[0]), even_length(lengths[1]), even_length(lengths[2])};
    const Index lines = lengths[0] * lengths[1];
    AlignedVector<double> in(static_cast<std::size_t>(lines * lengths[2]));
    AlignedVector<Complex> out(static_cast<std::size_t>(lines * (lengths[2] / 2 + 1)));
    plan_ = planned(fftw_plan_dft_r2c, 3, n.data(), in.data(), fftw(out));
}

void GridTransform::operator()(AlignedVector<double>& x, AlignedVector<Complex>& transformed) const {
    fftw_execute_dft_r2c(plan_->plan, x.data(), fftw(transformed));
}

SineTransform::SineTransform(Index n) : plan_(real_to_real(at_least(1, n), FFTW_RODFT10)) {}

void SineTransform::operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const {
    fftw_execute_r2r(plan_->plan, x.data(), transformed.data());
}

CosineTransform::CosineTransform(Index n) : plan_(real_to_real(at_least(2, n), FFTW_REDFT00)) {}

void CosineTransform::operator()(AlignedVector<double>& x, AlignedVector<double>& transformed) const {
    fftw_execute_r2r(plan_->plan, x.data(), transformed.data());
}

}  // namespace ljmd
