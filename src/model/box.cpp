#include "ljmd/model/box.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

void require_usable(const Vec3& edges) {
    if (!edges.allFinite() || !(edges.minCoeff() > 0.0)) {
        throw InputError(fmt::format(
            "a box needs edges that are finite, above 0 and not 10^15 times as long as another; found {}, {} and {}",
            edges[0], edges[1], edges[2]));
    }
}

}  // namespace

Box::Box(const Vec3& edges) {
    require_usable(edges);
    // frexp gives 1.5 L = m 2^e with m in [0.5, 1), so 2^e is the smallest power of two above 1.5 L.
    int exponent = 0;
    std::frexp(1.5 * edges.maxCoeff(), &exponent);
    resolution_ = std::ldexp(1.0, exponent - 52);
    // Doubles between 2^e and 2^(e+1) are spaced by g. Adding 1.25 * 2^e brings r into that range, where it is rounded.
    rounding_ = 1.25 * std::ldexp(1.0, exponent);
    edges_ = (edges / resolution_).array().round() * resolution_;
    require_usable(edges_);  // an edge may vanish beside a much longer one, or overflow
}

Vec3 Box::crossings(const Vec3& r) const {
    Vec3 n = (r.array() / edges_.array()).floor();
    for (int a = 0; a < 3; ++a) {  // the division rounds: an atom close to a wall may be counted on the wrong side
        if (r[a] - n[a] * edges_[a] < 0.0) {
            n[a] -= 1.0;
        } else if (r[a] - n[a] * edges_[a] >= edges_[a]) {
            n[a] += 1.0;
        }
    }
    return n;
}

}  // namespace ljmd
