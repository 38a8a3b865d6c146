#include "observables/fourier_lengths.hpp"

#include <fmt/format.h>

#include <limits>

#include "ljmd/core/errors.hpp"
#include "observables/fourier.hpp"

namespace ljmd {

int even_length(Index n) {
    if (n < 2 || n % 2 != 0 || n > std::numeric_limits<int>::max()) {
        throw ContractViolation(fmt::format("a transform of real numbers needs an even length, not {}", n));
    }
    return static_cast<int>(n);
}

int at_least(Index least, Index n) {
    if (n < least || n > std::numeric_limits<int>::max()) {
        throw ContractViolation(fmt::format("a transform needs a length of at least {}, not {}", least, n));
    }
    return static_cast<int>(n);
}

Index fast_length(Index n) {
    if (n < 1) {
        throw ContractViolation(fmt::format("a transform needs a length of at least 1, not {}", n));
    }
    const auto is_fast = [](Index length) {
        for (const Index prime : {2, 3, 5, 7}) {
            while (length % prime == 0) {
                length /= prime;
            }
        }
        return length == 1;
    };
    Index length = n + n % 2;
    while (!is_fast(length)) {
        length += 2;
    }
    return length;
}

}  // namespace ljmd
