#include "observables/pairs_too_near.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "model/all_atoms.hpp"

namespace ljmd {

namespace {

std::string where(const PairPotential& potential) {
    return fmt::format(
        "nearer than {:.6g}, where the table of the pair potential {} begins, and below which its force is constant",
        potential.starts_at(), in_quotes(potential.formula()));
}

constexpr const char* advice = "begin the table nearer than that (`start` of ljmd.pair in Python)";

}  // namespace

NearPairs pairs_too_near(const State& state, const PairPotential& potential) {
    return potential.starts_at() > 0.0 ? pairs_nearer_than(state, potential.starts_at()) : NearPairs{};
}

std::string too_near_in_words(const NearPairs& too_near, const PairPotential& potential) {
    if (too_near.count == 0) {
        return "";
    }
    return fmt::format("{} {} of atoms {} {}. The nearest is {:.4g} apart: {}", too_near.count,
                       too_near.count == 1 ? "pair" : "pairs", too_near.count == 1 ? "is" : "are", where(potential),
                       too_near.nearest, advice);
}

void PairsTooNear::sample(const State& state) {
    if (!(potential_.starts_at() > 0.0)) {
        return;
    }
    look_at_all_atoms(state, [this](const State& all) {
        const NearPairs found = pairs_too_near(all, potential_);
        ++samples_;
        if (found.count > 0) {
            nearest_ = samples_with_ > 0 ? std::min(nearest_, found.nearest) : found.nearest;
            ++samples_with_;
            pairs_ += found.count;
        }
    });
}

std::string PairsTooNear::remark() const {
    if (samples_with_ == 0) {
        return "";
    }
    return fmt::format(
        "in {} of {} samples pairs of atoms were {}: {:.3g} pairs a sample, the nearest {:.4g} apart. The averages are "
        "those of "
        "that softer potential: {}",
        samples_with_, samples_, where(potential_), static_cast<double>(pairs_) / static_cast<double>(samples_),
        nearest_, advice);
}

void PairsTooNear::archive(Archive& a) {
    if (potential_.starts_at() > 0.0) {
        a(samples_, samples_with_, pairs_, nearest_);
    }
}

}  // namespace ljmd
