#pragma once

namespace ljmd {

/// Ask the processor to load numbers into its caches that are used soon. @pre a readable range
inline void prefetch(const double* first, const double* last) {
    constexpr int numbers_of_line = 8;
    for (; first < last; first += numbers_of_line) {
        __builtin_prefetch(first);
    }
}

}  // namespace ljmd
