#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/quadrature.hpp"
#include "execution/loops.hpp"
#include "observables/structure/density_modes.hpp"

namespace ljmd {

namespace {

using Complex = std::complex<double>;

constexpr Index width = 16;    // grid points that an atom is spread over in each direction
constexpr double finer = 1.5;  // than the largest wave numbers require
constexpr double shape = 0.976 * std::numbers::pi * static_cast<double>(width) * (1.0 - 0.5 / finer);  // beta

double kernel(double z) {
    const double inside = 1.0 - z * z;
    return inside > 0.0 ? std::exp(shape * (std::sqrt(inside) - 1.0)) : 0.0;
}

/// Place of an atom on the grid in one direction, with its weights.
struct Spread {
    Index first;  ///< first point, in [0, points)
    std::array<double, width> weights;
};

Spread spread(double r, double edge, Index points) {
    const double place = r / edge * static_cast<double>(points);
    const double first = std::ceil(place - 0.5 * static_cast<double>(width));
    Spread result{static_cast<Index>(first) % points, {}};
    result.first += result.first < 0 ? points : 0;
    for (std::size_t k = 0; k < result.weights.size(); ++k) {
        result.weights[k] = kernel((first + static_cast<double>(k) - place) / (0.5 * static_cast<double>(width)));
    }
    return result;
}

/// Factor by which spreading multiplies the component n.
double attenuation(Index n, Index points) {
    const double half = 0.5 * static_cast<double>(width);
    const double frequency = 2.0 * std::numbers::pi * static_cast<double>(n) * half / static_cast<double>(points);
    return 2.0 * half * integrate([frequency](double z) { return kernel(z) * std::cos(frequency * z); }, 0.0, 1.0);
}

Index grid_points(Index largest) {
    return fast_length(std::max(static_cast<Index>(std::ceil(finer * static_cast<double>(2 * largest + 1))), width));
}

class GridDensityModes : public DensityModes {
  public:
    GridDensityModes(const Box& box, const Numbers& largest)
        : edges_(box.edges()),
          points_{grid_points(largest[0]), grid_points(largest[1]), grid_points(largest[2])},
          transform_(points_),
          density_(static_cast<std::size_t>(points_[0] * points_[1] * points_[2])),
          transformed_(static_cast<std::size_t>(points_[0] * points_[1] * (points_[2] / 2 + 1))) {
        for (std::size_t a = 0; a < 3; ++a) {
            for (Index n = 0; n <= largest[a]; ++n) {
                restoring_[a].push_back(1.0 / attenuation(n, points_[a]));
            }
        }
    }

    void prepare(const State& state) override {
        spread_atoms(state);
        // Planes are filled one by one, each with its atoms in a fixed order. So no two threads write the same point,
        // and sums do not depend on the number of threads.
        for_each_block(state.execution(), points_[0], 1, [&](Index first, Index last) {
            for (Index x = first; x < last; ++x) {
                fill_plane(x);
            }
        });
        transform_(density_, transformed_);
    }

    void get(Index n_x, Index n_y, std::vector<Complex>& rod) const override {
        const Index row = (n_x < 0 ? n_x + points_[0] : n_x) * points_[1] + (n_y < 0 ? n_y + points_[1] : n_y);
        const Complex* found = transformed_.data() + row * (points_[2] / 2 + 1);
        const double in_plane = restoring_[0][static_cast<std::size_t>(std::abs(n_x))] *
                                restoring_[1][static_cast<std::size_t>(std::abs(n_y))];
        for (std::size_t n_z = 0; n_z < rod.size(); ++n_z) {
            rod[n_z] = found[n_z] * (in_plane * restoring_[2][n_z]);
        }
    }

  private:
    using SpreadAtom = std::array<Spread, 3>;

    /// Sort the atoms by the first plane that they are spread over.
    void spread_atoms(const State& state) {
        const Index atoms = state.count();
        const auto r = state.positions();
        spreads_.resize(static_cast<std::size_t>(atoms));
        for_each_index(state.execution(), atoms, [&](Index i) {
            for (Index a = 0; a < 3; ++a) {
                const auto direction = static_cast<std::size_t>(a);
                spreads_[static_cast<std::size_t>(i)][direction] = spread(r(a, i), edges_[a], points_[direction]);
            }
        });
        begins_.assign(static_cast<std::size_t>(points_[0] + 1), 0);
        for (const SpreadAtom& atom : spreads_) {
            ++begins_[static_cast<std::size_t>(atom[0].first + 1)];
        }
        for (std::size_t x = 1; x < begins_.size(); ++x) {
            begins_[x] += begins_[x - 1];
        }
        sorted_.resize(spreads_.size());
        std::vector<Index> next(begins_);
        for (Index i = 0; i < atoms; ++i) {
            const auto first = static_cast<std::size_t>(spreads_[static_cast<std::size_t>(i)][0].first);
            sorted_[static_cast<std::size_t>(next[first]++)] = i;
        }
    }

    void fill_plane(Index x) {
        double* plane = density_.data() + x * points_[1] * points_[2];
        std::fill_n(plane, points_[1] * points_[2], 0.0);
        for (Index k = 0; k < width; ++k) {
            const auto begin = static_cast<std::size_t>(x >= k ? x - k : x - k + points_[0]);
            for (Index s = begins_[begin]; s < begins_[begin + 1]; ++s) {
                const auto i = static_cast<std::size_t>(sorted_[static_cast<std::size_t>(s)]);
                add_to_plane(spreads_[i], spreads_[i][0].weights[static_cast<std::size_t>(k)], plane);
            }
        }
    }

    void add_to_plane(const SpreadAtom& atom, double weight, double* plane) const {
        const Index in_line =
            std::min(width, points_[2] - atom[2].first);  // the rest goes to the beginning of the line
        for (std::size_t b = 0; b < atom[1].weights.size(); ++b) {
            const Index y = (atom[1].first + static_cast<Index>(b)) % points_[1];
            double* line = plane + y * points_[2];
            const double share = weight * atom[1].weights[b];
            for (Index c = 0; c < in_line; ++c) {
                line[atom[2].first + c] += share * atom[2].weights[static_cast<std::size_t>(c)];
            }
            for (Index c = in_line; c < width; ++c) {
                line[c - in_line] += share * atom[2].weights[static_cast<std::size_t>(c)];
            }
        }
    }

    Vec3 edges_;
    Numbers points_;
    GridTransform transform_;
    std::array<std::vector<double>, 3> restoring_;  ///< 1/attenuation, by direction and n
    AlignedVector<double> density_;
    AlignedVector<Complex> transformed_;
    std::vector<SpreadAtom> spreads_;  ///< by index
    std::vector<Index> begins_;        ///< index in `sorted_` of the first atom whose spread begins on each plane
    std::vector<Index> sorted_;
};

}  // namespace

std::unique_ptr<DensityModes> grid_density_modes(const Box& box, const DensityModes::Numbers& largest) {
    return std::make_unique<GridDensityModes>(box, largest);
}

}  // namespace ljmd
