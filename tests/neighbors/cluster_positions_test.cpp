#include "ljmd/neighbors/cluster_positions.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "ljmd/neighbors/fixed_point.hpp"
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
    /// check(place, i, axis, shift) for every slot with an atom, empty(place) for the others.
    template <class Check, class Empty>
    void for_each(Check&& check, Empty&& empty) const {
        for (Index c = 0; c < grid.with_images(); ++c) {
            const ClusterGrid::Members members = grid.members(c);
            for (int axis = 0; axis < 3; ++axis) {
                for (int k = 0; k < 4; ++k) {
                    const Index place = 12 * c + 4 * axis + k;
                    k < members.count ? check(place, members.first + k, axis, members.shift[axis]) : empty(place);
                }
            }
        }
    }
};

}  // namespace

TEST_CASE("positions of clusters are those of their atoms, images a shift away, to the last bit") {
    const Sample sample;
    ClusterPositions<double> positions;
    positions.update(
        sample.grid, sample.state, [](double x, int) { return x; }, [](double dx) { return dx; }, -1e9);
    bool right = true;
    Index empty = 0;
    sample.for_each(
        [&](Index place, Index i, int axis, double shift) {
            right = right && positions.data()[place] == sample.state.positions()(axis, i) + shift;
        },
        [&](Index place) {
            right = right && positions.data()[place] == -1e9;
            ++empty;
        });
    CHECK(right);
    CHECK(empty > 0);
}

TEST_CASE("in fixed point an image lies the same number of units away on either side") {
    const Sample sample;
    const FixedPoint fixed_point(sample.state.box(), 5.6);
    ClusterPositions<std::int32_t> positions;
    positions.update(
        sample.grid, sample.state, fixed_point, [&](double dx) { return fixed_point.distance(dx); },
        FixedPoint::far_away);
    bool right = true;
    sample.for_each(
        [&](Index place, Index i, int axis, double shift) {
            const std::int32_t units = fixed_point.distance(shift);
            right = right && units == -fixed_point.distance(-shift);
            right = right && std::abs(units * fixed_point.unit() - shift) <= 0.5 * fixed_point.unit();
            right = right && positions.data()[place] == fixed_point(sample.state.positions()(axis, i), axis) + units;
        },
        [&](Index place) { right = right && positions.data()[place] == FixedPoint::far_away; });
    CHECK(right);
}
