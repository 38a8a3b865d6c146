#include "neighbors/ghost_routes.hpp"

#include <mutex>
#include <vector>
#include "catch.hpp"

#include "ljmd/model/lattice.hpp"
#include "model/shared_state.hpp"

using namespace ljmd;
using test::RankTeam;

namespace {

/// The number of each atom's copies among the ghost clusters of all tiles, by id: what routes bring to it if each copy
/// finds the force 1.
std::vector<double> copies(int size, const std::vector<Vec3>& positions, const Box& box) {
    const auto atoms = static_cast<Index>(positions.size());
    std::vector<double> found(positions.size(), 0.0);
    std::mutex mutex;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        Ranks& here = *ranks;
        State state = test::share_of(positions, box, ranks);
        ClusterGrid grid;
        grid.configure(box, 1.6, atoms, 60, 2.0, here);
        grid.sort(state);
        std::vector<std::vector<ClusterGrid::GhostClusters>> ghosts;
        std::vector<AlignedVector<double>> forces;
        for (std::size_t t = 0; t < grid.tiles().size(); ++t) {
            const ClusterGrid::Neighborhood around = grid.neighborhood(t);
            ghosts.push_back(around.ghosts());
            const auto clusters = static_cast<std::size_t>(around.cluster_count() - around.own().length());
            forces.emplace_back(std::size_t{12} * clusters, 1.0);
        }
        const std::vector<std::span<const ClusterGrid::GhostClusters>> spans(ghosts.begin(), ghosts.end());
        GhostRoutes routes;
        routes.find(grid, spans, here);
        routes.begin_exchange(here, forces);
        here.finish_exchange();
        const std::lock_guard lock(mutex);
        for (Index t = 0; t < static_cast<Index>(grid.tiles().size()); ++t) {
            for (const GhostRoutes::Export& each : routes.of_tile(t)) {
                const double* from =
                    each.tile < 0 ? routes.received() : forces[static_cast<std::size_t>(each.tile)].data();
                for (std::uint32_t k = 0; k < each.count; ++k) {
                    found[static_cast<std::size_t>(state.ids()[each.first + k])] += from[each.offset + 3 * k + 2];
                }
            }
        }
    });
    return found;
}

}  // namespace

TEST_CASE("what is found for copies of an atom comes to the atom, whichever rank has it") {
    const Box box = GENERATE(Box({9.0, 10.0, 11.0}), Box({5.0, 6.0, 25.0}));
    const std::vector<Vec3> positions = random_positions(700, box, 5);
    const std::vector<double> expected = copies(1, positions, box);
    double most = 0.0;
    for (const double each : expected) {
        most = std::max(most, each);
    }
    CHECK(most > 3.0);
    for (const int size : {2, 3, 8, 20}) {
        CHECK(copies(size, positions, box) == expected);
    }
}
