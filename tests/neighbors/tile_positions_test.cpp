#include "neighbors/tile_positions.hpp"

#include <cmath>
#include "catch.hpp"

#include "neighbors/fixed_point.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

struct Sample {
    State state = test::random_state(301, Box(Vec3(6.1, 7.3, 8.9)), 29);
    ClusterGrid grid;
    Sample() {
        grid.configure(state.box(), 2.8, state.count());
        grid.sort(state);
    }
    /// check(place, i, axis, shift) for every slot with an atom of a tile and its ghosts, empty(place) for the others.
    template <class Check, class Empty>
    void for_each(const ClusterGrid::Neighborhood& tile, Check&& check, Empty&& empty) const {
        const auto visit = [&](const ClusterGrid::Run& clusters, Index first, const Vec3& shift) {
            for (Index n = 0; n < clusters.length(); ++n) {
                const AtomRange atoms = grid.atoms_of_cluster(clusters.first + n);
                for (int axis = 0; axis < 3; ++axis) {
                    for (int k = 0; k < 4; ++k) {
                        const Index place = 12 * (first + n) + 4 * axis + k;
                        k < atoms.count() ? check(place, atoms.first + k, axis, shift[axis]) : empty(place);
                    }
                }
            }
        };
        visit(tile.own(), 0, Vec3::Zero());
        for (const ClusterGrid::GhostClusters& ghosts : tile.ghosts()) {
            visit(ghosts.of, ghosts.first, ghosts.shift);
        }
    }
};

}  // namespace

TEST_CASE("positions of a tile are those of its atoms and ghosts, images a shift away, to the last bit") {
    const Sample sample;
    TilePositions<double> positions;  // the same for all tiles: nothing is left of the one before
    bool right = true;
    Index empty = 0;
    Index shifted = 0;
    for (std::size_t t = 0; t < sample.grid.tiles().size(); ++t) {
        const ClusterGrid::Neighborhood tile = sample.grid.neighborhood(t);
        positions.update(
            sample.grid, tile.own(), tile.ghosts(), tile.cluster_count(), sample.state, [](double x, int) { return x; },
            [](double dx) { return dx; }, -1e9);
        sample.for_each(
            tile,
            [&](Index place, Index i, int axis, double shift) {
                right = right && positions.data()[place] == sample.state.positions()(axis, i) + shift;
                shifted += shift != 0.0 ? 1 : 0;
            },
            [&](Index place) {
                right = right && positions.data()[place] == -1e9;
                ++empty;
            });
    }
    CHECK(right);
    CHECK(empty > 0);
    CHECK(shifted > 0);
}

TEST_CASE("in fixed point an image lies the same number of units away on either side") {
    const Sample sample;
    const FixedPoint fixed_point(sample.state.box(), 5.6);
    TilePositions<std::int32_t> positions;
    const ClusterGrid::Neighborhood tile = sample.grid.neighborhood(0);
    positions.update(
        sample.grid, tile.own(), tile.ghosts(), tile.cluster_count(), sample.state, fixed_point,
        [&](double dx) { return fixed_point.distance(dx); }, FixedPoint::far_away);
    bool right = true;
    sample.for_each(
        tile,
        [&](Index place, Index i, int axis, double shift) {
            const std::int32_t units = fixed_point.distance(shift);
            right = right && units == -fixed_point.distance(-shift);
            right = right && std::abs(units * fixed_point.unit() - shift) <= 0.5 * fixed_point.unit();
            right = right && positions.data()[place] == fixed_point(sample.state.positions()(axis, i), axis) + units;
        },
        [&](Index place) { right = right && positions.data()[place] == FixedPoint::far_away; });
    CHECK(right);
}
