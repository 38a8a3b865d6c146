#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/run_lines.hpp"

namespace ljmd {

/// The share of one of several workers: of a list the entries number K, K + T, K + 2 T, ..., counted from 1.
struct WorkShare {
    std::size_t part;   ///< K
    std::size_t parts;  ///< T

    /// Whether an entry belongs to it. @param index  of the entry, from 0
    [[nodiscard]] bool has(std::size_t index) const { return index % parts == part - 1; }
};

inline constexpr std::size_t max_workers = 10'000;

/// The share that "K/T" means. @throws InputError  unless 1 <= K <= T <= max_workers
[[nodiscard]] WorkShare work_share(const std::string& text);

/// The lines of a share.
[[nodiscard]] std::vector<RunLine*> lines_of(const WorkShare& share, const std::vector<RunLine*>& lines);

}  // namespace ljmd
