#include "execution/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ljmd {

void ExactSum::add_special(double term) {
    ++words_[digit_count + (std::isnan(term) ? 2 : term < 0.0 ? 1 : 0)];
}

void ExactSum::carry() {
    for (std::size_t k = 0; k + 1 < digit_count; ++k) {
        words_[k + 1] += words_[k] >> bits_per_digit;
        words_[k] &= lower_bits;
    }
    pending_ = 1;
}

void ExactSum::add(const ExactSum& other) {
    if (pending_ + other.pending_ >= most_pending) {
        carry();
    }
    for (std::size_t k = 0; k < words_.size(); ++k) {
        words_[k] += other.words_[k];
    }
    pending_ += other.pending_;
}

ExactSum::Words ExactSum::words() const {
    ExactSum carried = *this;
    carried.carry();
    return carried.words_;
}

double ExactSum::value() const {
    const std::int64_t* specials = words_.data() + digit_count;
    if (specials[2] > 0 || (specials[0] > 0 && specials[1] > 0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (specials[0] > 0 || specials[1] > 0) {
        return specials[0] > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
    }
    ExactSum magnitude = *this;
    magnitude.carry();
    const bool negative = magnitude.words_[digit_count - 1] < 0;
    if (negative) {
        for (std::size_t k = 0; k < digit_count; ++k) {
            magnitude.words_[k] = -magnitude.words_[k];
        }
        magnitude.carry();
    }
    const Words& digits = magnitude.words_;
    std::size_t top = digit_count - 1;
    while (top > 0 && digits[top] == 0) {
        --top;
    }
    // The three highest digits have at least 65 bits, of which 64 are kept. If others are not zero, the last one is
    // set: then the conversion of the whole number to a double rounds as the whole sum's would.
    const auto digit = [&](std::size_t below) { return below <= top ? static_cast<Uint128>(digits[top - below]) : 0; };
    const Uint128 highest = digit(0) << 64 | digit(1) << 32 | digit(2);
    const auto upper = static_cast<std::uint64_t>(highest >> 64);
    const int surplus = upper == 0 ? 0 : 64 - std::countl_zero(upper);
    auto kept = static_cast<std::uint64_t>(highest >> surplus);
    const bool more = (highest >> surplus) << surplus != highest ||
                      (top > 2 && std::any_of(digits.begin(), digits.begin() + static_cast<std::ptrdiff_t>(top) - 2,
                                              [](std::int64_t each) { return each != 0; }));
    kept |= more ? 1 : 0;
    const int place = bits_per_digit * (static_cast<int>(top) - 2) + surplus - 1074;
    const double rounded = std::ldexp(static_cast<double>(kept), place);
    return negative ? -rounded : rounded;
}

}  // namespace ljmd
