#pragma once

namespace ljmd {

/// How the pairs of two clusters fill the vectors of a kernel. A row, consecutive atoms of one cluster, meets a part,
/// consecutive slots of the other. Lists hold parts.
struct RowShape {
    int atoms;   ///< atoms of a row: 1, 2 or 4
    int others;  ///< slots of a part: 2 or 4, no fewer than `atoms`

    [[nodiscard]] bool operator==(const RowShape&) const = default;
};

}  // namespace ljmd
