#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ljmd {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

/// Sum of doubles without rounding: value() is the exact sum of all terms, rounded once to the nearest double. So it
/// depends neither on the order of the terms nor on how they are divided among threads, and two sums are added without
/// rounding.
///
/// The sum is a fixed-point number, wide enough for every double. It has digits of 32 bits; the lowest digit counts
/// units of 2^-1074. Each digit is kept in 64 bits, so that carries can wait. Terms of usual size (ExactBlock) take no
/// longer than an ordinary sum. Source: R. M. Neal (2015), Fast exact summation using small and large
/// superaccumulators, arXiv:1505.05571
class ExactSum {
  public:
    /// Add a term. Infinities add up as in floating point, and a NaN makes the sum a NaN.
    void add(double term) {
        const auto bits = std::bit_cast<std::uint64_t>(term);
        const auto exponent = static_cast<int>(bits >> 52 & 0x7ff);
        if ((bits << 1) == 0) {
            return;
        }
        if (exponent == 0x7ff) {
            add_special(term);
            return;
        }
        constexpr std::uint64_t implied = std::uint64_t{1} << 52;
        const auto mantissa = static_cast<std::int64_t>((bits & (implied - 1)) | (exponent > 0 ? implied : 0));
        add_integer(term < 0.0 ? -mantissa : mantissa, exponent > 0 ? exponent - 1 : 0);
    }

    /// Add n 2^(place - 1074). @pre 0 <= place <= 2046
    void add_integer(std::int64_t n, int place) {
        const Int128 shifted = static_cast<Int128>(n) << (place % bits_per_digit);
        const auto k = static_cast<std::size_t>(place / bits_per_digit);
        words_[k] += static_cast<std::int64_t>(shifted & lower_bits);
        words_[k + 1] += static_cast<std::int64_t>(shifted >> bits_per_digit & lower_bits);
        words_[k + 2] += static_cast<std::int64_t>(shifted >> (2 * bits_per_digit));
        if (++pending_ == most_pending) {
            carry();
        }
    }

    /// Add the terms of another sum.
    void add(const ExactSum& other);

    /// The sum, rounded to the nearest double, to the even one of two; infinite if it is too large for one; 0 without
    /// terms, and where they cancel.
    [[nodiscard]] double value() const;

    /// Enough digits for the 2098 bits of all doubles and for the carries of 2^60 terms, and the number of terms that
    /// are inf, -inf or NaN.
    static constexpr std::size_t digit_count = 68;
    using Words = std::array<std::int64_t, digit_count + 3>;

    /// The sum as whole numbers. Added one by one to the numbers of other sums, a million at most, they make the words
    /// of the sum of all.
    [[nodiscard]] Words words() const;
    /// A sum from its words.
    explicit ExactSum(const Words& words) : words_(words), pending_(most_sums) {}
    ExactSum() = default;

  private:
    static constexpr int bits_per_digit = 32;
    static constexpr std::int64_t lower_bits = (std::int64_t{1} << bits_per_digit) - 1;
    static constexpr std::int64_t most_sums = std::int64_t{1} << 20;
    /// A term adds less than 2^32 to a digit, so that this many can be added before carries are passed on.
    static constexpr std::int64_t most_pending = std::int64_t{1} << 30;

    void add_special(double term);
    /// Pass carries on: all digits but the highest are in [0, 2^32) then.
    void carry();

    Words words_{};             ///< digits from the lowest up; then numbers of inf, -inf and NaN
    std::int64_t pending_ = 0;  ///< terms since carries were passed on
};

/// Adds up to 1024 terms for an ExactSum. Those with 2^-21 <= |x| < 2^30, nearly all in reduced units, are cut into two
/// whole numbers: x rounded to a multiple of 2^-21, and the rest, a multiple of 2^-73. Adding a number to x that is
/// large enough rounds it so, and leaves the whole number in the lowest bits.
class ExactBlock {
  public:
    static constexpr std::size_t most_terms = 1024;

    /// @param rest  takes terms of other sizes
    void add(double term, ExactSum& rest) {
        const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(term) & ~sign;
        if (magnitude - lowest < highest - lowest) [[likely]] {
            const double rounded = term + to_coarse;
            coarse_ += std::bit_cast<std::uint64_t>(rounded) - std::bit_cast<std::uint64_t>(to_coarse);
            fine_ += std::bit_cast<std::uint64_t>((term - (rounded - to_coarse)) + to_fine) -
                     std::bit_cast<std::uint64_t>(to_fine);
        } else {
            rest.add(term);
        }
    }

    /// Add all to a sum, and begin again.
    void move_to(ExactSum& sum) {
        sum.add_integer(static_cast<std::int64_t>(coarse_), 1074 - coarse_bits);
        sum.add_integer(static_cast<std::int64_t>(fine_), 1074 - fine_bits);
        coarse_ = fine_ = 0;
    }

  private:
    static constexpr int coarse_bits = 21;
    static constexpr int fine_bits = 73;
    static constexpr double to_coarse = 0x1.8p31;  // the last bit of its mantissa is worth 2^-21
    static constexpr double to_fine = 0x1.8p-21;   // 2^-73
    static constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    static constexpr std::uint64_t lowest = std::bit_cast<std::uint64_t>(0x1p-21);
    static constexpr std::uint64_t highest = std::bit_cast<std::uint64_t>(0x1p30);

    std::uint64_t coarse_ = 0;  // two's complement
    std::uint64_t fine_ = 0;
};

}  // namespace ljmd
