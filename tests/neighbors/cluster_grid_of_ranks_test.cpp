#include <algorithm>
#include <mutex>
#include <vector>
#include "catch.hpp"

#include "ljmd/model/lattice.hpp"
#include "model/shared_state.hpp"
#include "neighbors/cluster_grid.hpp"

using namespace ljmd;
using test::RankTeam;

namespace {

constexpr double range = 1.6;
constexpr double halo = 2.0;
constexpr Index tile = 60;

}  // namespace

TEST_CASE("of several ranks each has the atoms of its tiles, in the order of one process") {
    const Index atoms = 700;
    const Box box = GENERATE(Box({9.0, 10.0, 11.0}), Box({5.0, 6.0, 30.0}));
    const std::vector<Vec3> positions = random_positions(atoms, box, 5);
    State alone = test::share_of(positions, box, nullptr);
    ClusterGrid expected;
    expected.configure(box, range, atoms, tile);
    expected.sort(alone);
    const int size = GENERATE(2, 3, 8, 20);
    const auto all = static_cast<Index>(expected.tiles().size());
    REQUIRE(all > 6);
    std::mutex mutex;
    std::vector<std::vector<Index>> ids(static_cast<std::size_t>(size));
    bool right = true;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        const int rank = ranks->rank();
        const Ranks& here = *ranks;
        State state = test::share_of(positions, box, std::move(ranks));
        ClusterGrid grid;
        grid.configure(box, range, atoms, tile, halo, here);
        grid.sort(state);
        const Share share = even_share(all, here);
        const std::lock_guard lock(mutex);
        right = right && grid.first_tile() == share.first && static_cast<Index>(grid.tiles().size()) == share.count();
        for (Index t = 0; t < share.count(); ++t) {
            const AtomRange ours = grid.atoms_of_tile(t);
            const AtomRange theirs = expected.atoms_of_tile(share.first + t);
            right = right && ours.count() == theirs.count();
        }
        ids[static_cast<std::size_t>(rank)] = state.ids();
    });
    CHECK(right);
    std::vector<Index> joined;
    for (const std::vector<Index>& of_rank : ids) {
        joined.insert(joined.end(), of_rank.begin(), of_rank.end());
    }
    CHECK(joined == alone.ids());
}

TEST_CASE("of two atoms near each other at different ranks, one rank has the other's in its halo") {
    const Index atoms = 900;
    const Box box = GENERATE(Box({8.0, 9.0, 16.0}), Box({4.2, 5.0, 50.0}), Box({40.0, 5.5, 5.0}));
    std::vector<Vec3> positions = random_positions(atoms, box, 6);
    std::transform(positions.begin(), positions.end(), positions.begin(), [&](const Vec3& r) { return box.snap(r); });
    const int size = GENERATE(2, 5);
    std::mutex mutex;
    std::vector<int> rank_of(positions.size());
    std::vector<std::vector<bool>> knows(static_cast<std::size_t>(size));  // by rank and id: own atoms and ghosts
    bool own_alone = true;
    double volume = 0.0;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        const Ranks& here = *ranks;
        const int rank = here.rank();
        State state = test::share_of(positions, box, std::move(ranks));
        ClusterGrid grid;
        grid.configure(box, range, atoms, tile, halo, here);
        grid.sort(state);
        const auto known = std::as_const(state).positions_and_ghosts();
        std::vector<bool> of_id(positions.size());
        Index twice = 0;
        for (Index i = 0; i < known.cols(); ++i) {
            const auto found = std::find(positions.begin(), positions.end(), Vec3(known.col(i))) - positions.begin();
            twice += of_id.at(static_cast<std::size_t>(found)) ? 1 : 0;
            of_id[static_cast<std::size_t>(found)] = true;
        }
        double halo_volume = 0.0;
        Index halo_columns = 0;
        for (const ClusterGrid::HaloPart& part : grid.halo_parts()) {
            halo_volume += part.volume;
            halo_columns += part.columns;
        }
        const double expected = static_cast<double>(atoms) / box.volume() * halo_volume;
        const std::lock_guard lock(mutex);
        // Whole clusters: up to three atoms more at both ends of a column.
        CHECK(static_cast<double>(state.ghost_count()) > 0.8 * expected);
        CHECK(static_cast<double>(state.ghost_count()) < 1.2 * expected + 6.0 * static_cast<double>(halo_columns));
        CHECK(halo_columns == grid.column_count() - grid.own_column_count());
        for (const Index id : state.ids()) {
            rank_of[static_cast<std::size_t>(id)] = rank;
        }
        volume += grid.own_volume();
        own_alone = own_alone && twice == 0;
        knows[static_cast<std::size_t>(rank)] = of_id;
    });
    CHECK(volume == Approx(box.volume()));
    CHECK(own_alone);
    Index pairs = 0;
    Index unseen = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3 d = positions[i] - positions[j];
            const Vec3 nearest = d - box.crossings(d + 0.5 * box.edges()).cwiseProduct(box.edges());
            if (rank_of[i] != rank_of[j] && nearest.norm() < halo) {
                ++pairs;
                unseen +=
                    knows[static_cast<std::size_t>(rank_of[i])][j] || knows[static_cast<std::size_t>(rank_of[j])][i]
                        ? 0
                        : 1;
            }
        }
    }
    CHECK(pairs > 300);
    CHECK(unseen == 0);
}

TEST_CASE("the halos of two ranks hold the atoms on one side of each tile alone") {
    const Index atoms = 16000;
    const auto volume_of_halos = [&](const Box& box) {
        std::mutex mutex;
        double volume = 0.0;
        RankTeam(2).run([&](std::shared_ptr<Ranks> ranks) {
            ClusterGrid grid;
            grid.configure(box, range, atoms, 1000, halo, *ranks);
            const std::lock_guard lock(mutex);
            for (const ClusterGrid::HaloPart& part : grid.halo_parts()) {
                volume += part.volume;
            }
        });
        return volume;
    };
    // Two halves with 2 x 2 tiles in a layer meet at two places. Each place belongs to one halo.
    CHECK(volume_of_halos(Box({20.0, 20.0, 80.0})) == Approx(2.0 * 20.0 * 20.0 * halo));
    // Along x a tile also sees what lies before it in the next layers along y and z. With both sides it would be 6969.
    CHECK(volume_of_halos(Box({80.0, 20.0, 20.0})) < 5500.0);
}

TEST_CASE("ranks share the work, not the tiles, where it is known") {
    const Box box({8.0, 8.0, 32.0});
    std::vector<Vec3> positions = random_positions(1200, box, 9);
    for (Vec3& r : positions) {
        r[2] *= 0.25;  // three quarters of the box are empty
    }
    const int size = GENERATE(2, 4);
    std::mutex mutex;
    Index most = 0;
    Index most_evenly = 0;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        Ranks& here = *ranks;
        State state = test::share_of(positions, box, std::move(ranks));
        ClusterGrid grid;
        grid.configure(box, range, 1200, tile, halo, here);
        grid.sort(state);
        const Index evenly = state.count();
        std::vector<std::int64_t> work(static_cast<std::size_t>(grid.tiles_of_all()), 0);
        for (Index t = 0; t < static_cast<Index>(grid.tiles().size()); ++t) {
            work[static_cast<std::size_t>(grid.first_tile() + t)] = grid.atoms_of_tile(t).count();
        }
        here.sum(work);
        grid.set_work(work);
        grid.configure(box, range, 1200, tile, halo, here);
        grid.sort(state);
        const std::lock_guard lock(mutex);
        most = std::max(most, state.count());
        most_evenly = std::max(most_evenly, evenly);
    });
    CHECK(most_evenly > 1200 / size * 3 / 2);
    CHECK(most < 1200 / size * 5 / 3);  // tiles are large here
}

TEST_CASE("a companion of a state gets its order, and passes from rank to rank with it") {
    const Index atoms = 500;
    const Box box({9.0, 9.0, 9.0});
    const std::vector<Vec3> positions = random_positions(atoms, box, 8);
    const int size = GENERATE(1, 3);
    std::mutex mutex;
    bool same = true;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        const Ranks& here = *ranks;
        State state = test::share_of(positions, box, std::move(ranks));
        State companion = state;
        companion.write_positions().setZero();
        ClusterGrid grid;
        grid.configure(box, range, atoms, tile, halo, here);
        grid.sort(state, &companion);
        const std::lock_guard lock(mutex);
        same = same && state.ids() == companion.ids();
    });
    CHECK(same);
}
