#pragma once

namespace ljmd {

/// How the pairs of two clusters fill the vectors of a kernel: a row of one's atoms that follow each other meets a part
/// of the other, slots that follow each other. What stands on lists are parts.
struct RowShape {
    int atoms;   ///< of a row: 1, 2 or 4
    int others;  ///< slots of a part: 2 or 4, no fewer than `atoms`

    [[nodiscard]] bool operator==(const RowShape&) const = default;
};

}  // namespace ljmd
