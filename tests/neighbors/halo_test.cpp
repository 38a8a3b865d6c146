#include "neighbors/halo.hpp"

#include <mutex>
#include <vector>
#include "catch.hpp"

#include "ljmd/model/lattice.hpp"
#include "model/shared_state.hpp"

using namespace ljmd;
using test::RankTeam;

namespace {

/// Two ranks of 10 atoms each; rank 0 has copies of atoms 12, 13 and 17 of rank 1, and that has atom 5 of rank 0.
Halo halo_of(int rank) {
    Halo halo;
    if (rank == 0) {
        halo.send(1, {{5, 6}});
        halo.receive(1, 3);
    } else {
        halo.send(0, {{2, 4}, {7, 8}});
        halo.receive(0, 1);
    }
    return halo;
}

}  // namespace

TEST_CASE("ghosts follow the atoms that they are copies of") {
    const Box box({10.0, 10.0, 10.0});
    const std::vector<Vec3> positions = random_positions(20, box, 4);
    std::mutex mutex;
    int right = 0;
    RankTeam(2).run([&](std::shared_ptr<Ranks> ranks) {
        const int rank = ranks->rank();
        State state = test::share_of(positions, box, std::move(ranks));
        Halo halo = halo_of(rank);
        state.set_ghost_count(halo.count());
        for (int turn = 0; turn < 3; ++turn) {
            state.write_positions().array() += 0.25;
            halo.refresh(state);
        }
        const auto ghosts = std::as_const(state).positions_and_ghosts().rightCols(halo.count());
        const std::vector<std::size_t> of =
            rank == 0 ? std::vector<std::size_t>{12, 13, 17} : std::vector<std::size_t>{5};
        const std::lock_guard lock(mutex);
        for (std::size_t k = 0; k < of.size(); ++k) {
            const Vec3 moved = box.snap(positions[of[k]]).array() + 0.25 + 0.25 + 0.25;
            right += ghosts.col(static_cast<Index>(k)) == moved ? 1 : 0;
        }
    });
    CHECK(right == 4);
}

TEST_CASE("forces on ghosts come back to their atoms, in the order in which they were found") {
    std::mutex mutex;
    std::vector<std::vector<Halo::OnAtom>> at_zero;
    std::vector<std::vector<Halo::OnAtom>> at_one;
    RankTeam(2).run([&](std::shared_ptr<Ranks> ranks) {
        const Halo halo = halo_of(ranks->rank());
        const bool is_root = ranks->is_root();
        std::vector<Halo::OnAtom> found{{0, {1.0, 2.0, 3.0}}};
        if (is_root) {
            found = {{2, {0.5, 0.0, 0.0}}, {0, {4.0, 5.0, 6.0}}, {2, {0.25, 0.0, 0.0}}};
        }
        auto back = halo.return_forces(*ranks, found);
        const std::lock_guard lock(mutex);
        (is_root ? at_zero : at_one) = std::move(back);
    });
    REQUIRE(at_zero.size() == 2);
    REQUIRE(at_zero[1].size() == 1);
    CHECK(at_zero[0].empty());
    CHECK(at_zero[1][0].atom == 5);
    CHECK(at_zero[1][0].force == std::array{1.0, 2.0, 3.0});
    REQUIRE(at_one[0].size() == 3);
    CHECK(at_one[0][0].atom == 7);
    CHECK(at_one[0][0].force[0] == 0.5);
    CHECK(at_one[0][1].atom == 2);
    CHECK(at_one[0][2].atom == 7);
    CHECK(at_one[0][2].force[0] == 0.25);
}
