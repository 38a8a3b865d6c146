#pragma once

namespace ljmd {

// Elementary functions that have the same bits on every machine: additions, multiplications, divisions and exact
// operations alone, each rounded by itself. The C library's differ in the last digit from one library, and from
// one processor, to another. All are within one unit in the last place.

/// ln x; -inf for 0, NaN below.
[[nodiscard]] double logarithm(double x);

/// e^x
[[nodiscard]] double exponential(double x);

/// e^x - 1, without cancellation for small x.
[[nodiscard]] double exponential_minus_one(double x);

/// x^(1/3), also of negative numbers.
[[nodiscard]] double cube_root(double x);

struct SineAndCosine {
    double sine;
    double cosine;
};

/// sin(2 pi t) and cos(2 pi t). @pre |t| < 2^50
[[nodiscard]] SineAndCosine of_turns(double t);

/// sin x of an angle; NaN for angles of 2^50 and more, which have no digits left for it.
[[nodiscard]] double sine(double x);

}  // namespace ljmd
