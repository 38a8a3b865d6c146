#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "execution/test_execution.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/model/lattice.hpp"
#include "neighbors/all_pairs.hpp"

namespace ljmd::test {

/// Atoms at the given places, put onto the grid of the box.
inline State state_of(const std::vector<Vec3>& positions, const Box& box,
                      const Execution& execution = test_execution()) {
    State state(static_cast<Index>(positions.size()), box, execution);
    auto r = state.write_positions();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        r.col(static_cast<Index>(i)) = box.snap(positions[i]);
    }
    return state;
}

/// A state of uniformly random atoms, which may overlap.
inline State random_state(Index atoms, const Box& box, std::uint64_t seed,
                          const Execution& execution = test_execution()) {
    return state_of(random_positions(atoms, box, seed), box, execution);
}

inline State crystal_state(Lattice lattice, Index cells, const Box& box,
                           const Execution& execution = test_execution()) {
    return state_of(lattice_sites(lattice, cells, box), box, execution);
}

/// Move every atom by `length` in a random direction.
inline void displace(State& state, double length, std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3 direction = Vec3(normal(generator), normal(generator), normal(generator)).normalized();
        r.col(i) = state.snapped(r.col(i) + length * direction);
    }
}

/// An fcc crystal shaken until it is no crystal any more, but no atoms overlap: forces like those of a dense fluid.
inline State shaken_crystal(Index cells, double density, double length, std::uint64_t seed,
                            const Execution& execution = test_execution()) {
    const Box box = cubic_box(lattice_atoms(Lattice::fcc, cells), density);
    State state = crystal_state(Lattice::fcc, cells, box, execution);
    std::mt19937_64 generator(seed);
    displace(state, length, generator);
    return state;
}

/// Column id of the result belongs to atom id.
inline Eigen::Matrix3Xd by_id(const State& state, const ConstVectorView& values) {
    Eigen::Matrix3Xd result(3, state.count());
    for (Index i = 0; i < state.count(); ++i) {
        result.col(state.ids()[static_cast<std::size_t>(i)]) = values.col(i);
    }
    return result;
}

/// A pair as atom id i sees it: {id i, id j}.
using OrderedPair = std::pair<Index, Index>;

/// All ordered pairs with r < cutoff that a prepared search finds, sorted; one found twice stands there twice. A pair
/// that is found once for both sides is two ordered pairs.
///
/// A candidate j that is no local atom is a ghost. Its atom is the one at the same place but for whole edges, which is
/// looked for here, because a search does not say.
template <class Search>
std::vector<OrderedPair> pairs_within(const Search& search, const State& state, double cutoff) {
    const auto all = state.positions_and_ghosts();
    const auto id_of_column = [&](Index column) {
        if (column < state.count()) {
            return state.ids()[static_cast<std::size_t>(column)];
        }
        for (Index i = 0; i < state.count(); ++i) {
            const Vec3 d = (all.col(column) - all.col(i)).cwiseQuotient(state.box().edges());
            if ((d.array() - d.array().round()).abs().maxCoeff() < 1e-14) {
                return state.ids()[static_cast<std::size_t>(i)];
            }
        }
        return Index{-1};
    };
    std::vector<Index> id(static_cast<std::size_t>(all.cols()), Index{-2});  // -2: not asked for yet
    std::vector<OrderedPair> pairs;
    for (Index part = 0; part < search.part_count(state); ++part) {
        search.for_each_candidate(state, part, [&](const PairVisit& pair) {
            if (pair.dx * pair.dx + pair.dy * pair.dy + pair.dz * pair.dz < cutoff * cutoff) {
                const Index first = state.ids()[static_cast<std::size_t>(pair.i)];
                Index& second = id[static_cast<std::size_t>(pair.j)];
                second = second == -2 ? id_of_column(pair.j) : second;
                pairs.emplace_back(first, second);
                if (pair.once) {
                    pairs.emplace_back(second, first);
                }
            }
        });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// All ordered pairs with r < cutoff, sorted, by all-pairs: what every other search has to find.
inline std::vector<OrderedPair> all_pairs_within(State state, double cutoff) {
    AllPairs search;
    search.prepare(state, cutoff);
    return pairs_within(search, state, cutoff);
}

/// All separations r_i - r_j below the cutoff, of each pair from both sides, sorted. @pre a prepared search
template <class Search>
std::vector<std::array<double, 3>> separations_within(const Search& search, const State& state, double cutoff) {
    std::vector<std::array<double, 3>> separations;
    for (Index part = 0; part < search.part_count(state); ++part) {
        search.for_each_candidate(state, part, [&](const PairVisit& pair) {
            if (pair.dx * pair.dx + pair.dy * pair.dy + pair.dz * pair.dz < cutoff * cutoff) {
                separations.push_back({pair.dx, pair.dy, pair.dz});
                if (pair.once) {
                    separations.push_back({-pair.dx, -pair.dy, -pair.dz});
                }
            }
        });
    }
    std::sort(separations.begin(), separations.end());
    return separations;
}

/// True when the separations r_i - r_j < cutoff that atoms see are to the last bit the opposites of those seen by the
/// others, where both see each other. @pre a prepared search
template <class Search>
bool separations_are_opposite(const Search& search, const State& state, double cutoff) {
    using Place = std::array<double, 3>;
    std::vector<Place> seen;
    std::vector<Place> opposite;
    for (Index part = 0; part < search.part_count(state); ++part) {
        search.for_each_candidate(state, part, [&](const PairVisit& pair) {
            if (!pair.once && pair.dx * pair.dx + pair.dy * pair.dy + pair.dz * pair.dz < cutoff * cutoff) {
                seen.push_back({pair.dx, pair.dy, pair.dz});
                opposite.push_back({-pair.dx, -pair.dy, -pair.dz});
            }
        });
    }
    std::sort(seen.begin(), seen.end());
    std::sort(opposite.begin(), opposite.end());
    return !seen.empty() && seen == opposite;
}

}  // namespace ljmd::test
