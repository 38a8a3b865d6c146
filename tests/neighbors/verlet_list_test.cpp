#include "neighbors/verlet_list.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>
#include "catch.hpp"

#include "core/random.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

/// Bring the list up to date and compare its pairs with those of all-pairs.
bool agrees(VerletList& list, State& state, double cutoff) {
    const auto expected = test::all_pairs_within(state, cutoff);
    list.prepare(state, cutoff);
    return test::pairs_within(list, state, cutoff) == expected;
}

/// Move the atom of that id.
void move(State& state, Index id, const Vec3& d) {
    const Index i = state.index_of()[static_cast<std::size_t>(id)];
    auto r = state.write_positions();
    r.col(i) = state.snapped(r.col(i) + d);
}

}  // namespace

TEST_CASE("the list finds the pairs of all-pairs in random boxes") {
    const Vec3 shape = GENERATE(Vec3(1.0, 1.0, 1.0), Vec3(1.0, 1.4, 3.5));
    const double skin = GENERATE(0.0, 0.1, 0.3, 1.0);
    const double density = GENERATE(0.05, 0.4, 0.8442, 1.2);
    const double edge = GENERATE(5.0, 5.9, 7.3);  // 2 rc exactly, and between
    const Box box(edge * shape);
    State state = test::random_state(static_cast<Index>(std::min(density * box.volume(), 900.0)), box, 43);
    VerletList list(skin);
    CAPTURE(shape.transpose(), skin, density, edge);
    CHECK(agrees(list, state, 2.5));
    std::mt19937_64 generator(1);
    test::displace(state, 0.49 * skin, generator);
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 1);
}

TEST_CASE("the list is right in a box of 2 (rc + skin), one grid step more and one less") {
    const double skin = GENERATE(0.0, 0.1, 0.3, 1.0);
    const double edge = 2.0 * (2.5 + skin);
    const double step = GENERATE(0.0, 1.0, -1.0) * Box(Vec3::Constant(edge)).resolution();
    if (edge + step < 5.0) {
        return;  // smaller than 2 rc
    }
    const Box box(Vec3(edge + step, edge + step, 1.7 * edge));
    State state = test::random_state(300, box, 47);
    VerletList list(skin);
    std::mt19937_64 generator(2);
    for (int n = 0; n < 5; ++n) {
        CHECK(agrees(list, state, 2.5));
        test::displace(state, 0.3 * skin + 0.01, generator);
    }
}

TEST_CASE("the list agrees with all-pairs on shells of a crystal that lie at the cutoff") {
    const double constant = GENERATE(1.5, 1.0 / 3.0 + 1.25, 1.679, 1.7099, 2.0);
    const double shell = GENERATE(0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5);  // r^2 in units of the lattice constant's
    const double skin = GENERATE(0.0, 1e-9, 0.25);
    const double exact = constant * std::sqrt(shell);
    const double cutoff = GENERATE_COPY(exact, std::nextafter(exact, 0.0), std::nextafter(exact, 9.0));
    State state = test::crystal_state(Lattice::fcc, 4, Box(Vec3::Constant(4.0 * constant)));
    VerletList list(skin);
    CAPTURE(constant, shell, skin, cutoff);
    CHECK(agrees(list, state, cutoff));
}

TEST_CASE("without skin the list ends where the forces end, however the last bit of r^2 is rounded") {
    const Box box(Vec3::Constant(6.0));
    const Vec3 from = box.snap(Vec3::Constant(0.1));
    int lost = 0;
    for (Index k = 0; k < 2000; ++k) {
        const Vec3 d = box.snap(Vec3::Constant(0.8) + Random(127, RandomStream::positions).uniform(0, k));
        State state = test::state_of({from, from + d}, box);
        const double r = std::sqrt(d[0] * d[0] + (d[1] * d[1] + d[2] * d[2]));
        for (const double cutoff : {r, std::nextafter(r, 0.0), std::nextafter(r, 9.0)}) {
            VerletList list(0.0);
            lost += agrees(list, state, cutoff) ? 0 : 1;
        }
    }
    CHECK(lost == 0);
}

TEST_CASE("no pair is missed on a long random walk, and the list is rebuilt only when it must be") {
    const double skin = GENERATE(0.1, 0.4, 1.0);
    State state = test::random_state(250, Box(Vec3(5.0, 6.1, 7.9)), 53);
    VerletList list(skin);
    std::mt19937_64 generator(3);
    const int steps = 60;
    int late = 0;
    for (int step = 0; step < steps; ++step) {
        late += agrees(list, state, 2.5) ? 0 : 1;
        test::displace(state, (step % 7 == 0 ? 0.6 : 0.1) * skin, generator);  // above and below skin/2
    }
    CHECK(late == 0);
    CHECK(list.statistics().preparations == steps);
    CHECK(list.statistics().rebuilds > steps / 7);
    CHECK(list.statistics().rebuilds < steps / 2);
}

TEST_CASE("a list is rebuilt when two atoms that are not on it come within the cutoff") {
    // 0 and 1 are 2.81 apart, outside rc + skin = 2.8, and come nearer than rc by 0.51, 1.02, ... skins.
    const double skin = 0.3;
    const double moved = GENERATE(0.51, 1.02, 1.04, 1.2, 3.0) * skin;
    State state = test::state_of({{1.0, 1.0, 1.0}, {3.81, 1.0, 1.0}}, Box(Vec3::Constant(9.0)));
    VerletList list(skin);
    list.prepare(state, 2.5);
    move(state, 0, Vec3(moved, 0.0, 0.0));
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 2);  // of so few atoms one is too many to look around, see any_pair_missed()
}

TEST_CASE("a list serves on when atoms have moved by more than half the skin, but nobody has met whom it lacks") {
    const double skin = 0.3;
    State state = test::random_state(800, Box(Vec3(8.0, 9.0, 13.0)), 113);
    VerletList list(skin);
    std::mt19937_64 generator(7);
    Index rebuilds_by_half = 0;
    std::vector<Vec3> before;
    int late = 0;
    for (int step = 0; step < 60; ++step) {
        late += agrees(list, state, 2.5) ? 0 : 1;
        const auto r = static_cast<const State&>(state).positions();
        double longest = skin;
        if (!before.empty()) {
            longest = 0.0;
            for (std::size_t id = 0; id < before.size(); ++id) {
                longest = std::max(longest, (r.col(state.index_of()[id]) - before[id]).norm());
            }
        }
        if (longest > 0.5 * skin) {
            ++rebuilds_by_half;
            before.clear();
            for (const Index i : state.index_of()) {
                before.emplace_back(r.col(i));
            }
        }
        test::displace(state, 0.01 * skin, generator);
        for (Index id = 0; id < 6; ++id) {  // a few go straight on
            move(state, id, 0.12 * skin * Vec3(std::cos(id), std::sin(id), 0.3).normalized());
        }
    }
    CHECK(late == 0);
    CHECK(list.statistics().rebuilds > 3);
    CHECK(1.5 * static_cast<double>(list.statistics().rebuilds) < static_cast<double>(rebuilds_by_half));
}

TEST_CASE("two atoms that approach each other by half the skin each are on the list already") {
    const double skin = 0.3;
    State state = test::state_of({{1.0, 1.0, 1.0}, {3.79, 1.0, 1.0}}, Box(Vec3::Constant(9.0)));
    VerletList list(skin);
    list.prepare(state, 2.5);
    CHECK(test::pairs_within(list, state, 2.8).size() == 2);
    move(state, 0, Vec3(0.4999 * skin, 0.0, 0.0));
    move(state, 1, Vec3(-0.4999 * skin, 0.0, 0.0));
    list.prepare(state, 2.5);
    CHECK(list.statistics().rebuilds == 1);
    CHECK(test::pairs_within(list, state, 2.5).size() == 2);
    move(state, 1, Vec3(-0.0002 * skin, 0.0, 0.0));
    list.prepare(state, 2.5);
    CHECK(list.statistics().rebuilds == 2);
}

TEST_CASE("displacements are measured from the last rebuild, also for atoms that were moved in memory") {
    State state = test::random_state(200, Box(Vec3::Constant(6.5)), 59);
    VerletList list(0.4);
    list.prepare(state, 2.5);
    for (int n = 0; n < 3; ++n) {
        const Index before = list.statistics().rebuilds;
        for (int step = 0; step < 4; ++step) {  // 4 steps of 0.049: just below 0.2
            move(state, 17 + n, Vec3(0.0, 0.049, 0.0));
            list.prepare(state, 2.5);
        }
        CHECK(list.statistics().rebuilds == before);
        move(state, 17 + n, Vec3(0.0, 0.205, 0.0));  // by more than the skin in all
        list.prepare(state, 2.5);
        CHECK(list.statistics().rebuilds == before + 1);
    }
}

TEST_CASE("all pairs within cutoff + skin stand on the list, once for both sides") {
    State state = test::random_state(300, Box(Vec3(7.0, 6.0, 8.0)), 61);
    VerletList list(0.35);
    list.prepare_for(default_simd_level(), GENERATE(RowShape{1, 2}, RowShape{2, 2}, RowShape{2, 4}, RowShape{4, 4}));
    list.prepare(state, 2.5);
    CHECK(test::pairs_within(list, state, 2.85) == test::all_pairs_within(state, 2.85));
}

TEST_CASE("separations are those of all-pairs, to the last bit, whichever of the two has a pair on its list") {
    State state = test::random_state(150, Box(Vec3::Constant(5.7)), 67);
    VerletList list(0.3);
    AllPairs all_pairs;
    std::mt19937_64 generator(4);
    for (int step = 0; step < 5; ++step) {
        list.prepare(state, 2.5);
        State copy = state;
        all_pairs.prepare(copy, 2.5);
        const auto separations = test::separations_within(list, state, 2.5);
        CHECK(!separations.empty());
        CHECK((separations == test::separations_within(all_pairs, copy, 2.5)));
        test::displace(state, 0.1, generator);
    }
}

TEST_CASE("every ghost of a tile is known to the tile of its owner") {
    State state = test::shaken_crystal(16, 0.8442, 0.1, 7);
    VerletList list(0.3);
    list.prepare(state, 2.5);
    const ClusterGrid& grid = list.clusters();
    REQUIRE(grid.tiles().size() > 2);
    using Place = std::pair<std::int32_t, std::uint32_t>;  // tile and offset of forces on ghosts
    std::map<Place, ClusterGrid::Run> left;
    for (std::size_t t = 0; t < list.tiles().size(); ++t) {
        for (const ClusterGrid::GhostClusters& ghosts : list.tiles()[t].ghosts) {
            const std::int32_t number = ghosts.first - list.tiles()[t].ghosts.front().first;
            left[{static_cast<std::int32_t>(t), static_cast<std::uint32_t>(12 * number)}] = ghosts.of;
        }
    }
    bool right = true;
    for (Index owner = 0; owner < static_cast<Index>(grid.tiles().size()); ++owner) {
        const ClusterGrid::Run own = grid.tiles()[static_cast<std::size_t>(owner)];
        std::int32_t last = 0;
        for (const GhostRoutes::Export& exported : list.routes().of_tile(owner)) {
            const auto found = left.find({exported.tile, exported.offset});
            REQUIRE(found != left.end());
            const AtomRange atoms = grid.atoms_of(found->second);
            right = right && found->second.first >= own.first && found->second.last <= own.last &&
                    exported.tile >= last && exported.first == atoms.first && exported.count == atoms.count();
            last = exported.tile;
            left.erase(found);
        }
    }
    CHECK(right);
    CHECK(left.empty());
}

TEST_CASE("distance tests per atom do not grow with the number of atoms") {
    const double density = 0.8442;
    const double skin = 0.3;
    std::vector<double> tests;
    for (const Index cells : {10, 20, 25}) {
        const Index atoms = lattice_atoms(Lattice::fcc, cells);
        State state = test::random_state(atoms, cubic_box(atoms, density), 71);
        VerletList list(skin);
        list.prepare(state, 2.5);
        tests.push_back(static_cast<double>(list.statistics().distance_tests) / static_cast<double>(atoms));
    }
    CAPTURE(tests);
    CHECK(tests[1] == Approx(tests[0]).epsilon(0.15));
    CHECK(tests[2] == Approx(tests[0]).epsilon(0.15));
    CHECK(tests[2] < 500.0);
}

TEST_CASE("a list without skin serves as long as nothing moves") {
    State state = test::random_state(100, Box(Vec3::Constant(5.0)), 79);
    VerletList list(0.0);
    list.prepare(state, 2.5);
    list.prepare(state, 2.5);
    CHECK(list.statistics().rebuilds == 1);
    move(state, 3, Vec3(state.box().resolution(), 0.0, 0.0));
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 2);
    CHECK(list.skin() == 0.0);
}

TEST_CASE("a list is rebuilt for another cutoff, box or order") {
    State state = test::random_state(200, Box(Vec3::Constant(6.5)), 83);
    VerletList list(0.3);
    list.prepare(state, 2.0);
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 2);

    state.rescale_to(Box(Vec3::Constant(6.5 * (1.0 + 1e-9))));
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 3);

    std::vector<Index> reversed(200);
    for (std::size_t k = 0; k < reversed.size(); ++k) {
        reversed[k] = static_cast<Index>(reversed.size() - 1 - k);
    }
    state.reorder(reversed);
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 4);
}

TEST_CASE("the list of a droplet is rebuilt for another box or order, too") {
    // In the middle of the box, where no atom has neighbours among the images.
    std::vector<Vec3> droplet = random_positions(60, Box(Vec3::Constant(4.0)), 4);
    for (Vec3& r : droplet) {
        r += Vec3::Constant(5.5);
    }
    State state = test::state_of(droplet, Box(Vec3::Constant(15.0)));
    VerletList list(0.3);
    list.prepare(state, 2.5);
    std::vector<Index> order(60);
    std::iota(order.rbegin(), order.rend(), Index{0});
    state.reorder(order);
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 2);
    state.rescale_to(Box(Vec3::Constant(15.0 * (1.0 + 1e-9))));
    CHECK(agrees(list, state, 2.5));
    CHECK(list.statistics().rebuilds == 3);
}

TEST_CASE("a list needs no ghosts, and leaves those of others alone between rebuilds") {
    State state = test::random_state(200, Box(Vec3::Constant(6.5)), 89);
    VerletList list(0.3);
    list.prepare(state, 2.5);
    CHECK(state.ghost_count() == 0);
    state.set_ghost_count(2);
    state.write_ghosts().setOnes();
    CHECK(agrees(list, state, 2.5));
    CHECK(state.ghost_count() == 2);
    CHECK(list.statistics().rebuilds == 1);
}

TEST_CASE("lists are for rows that fill a vector of two, four, eight or sixteen lanes") {
    VerletList list(0.3);
    for (const RowShape shape :
         {RowShape{0, 0}, RowShape{1, 1}, RowShape{2, 1}, RowShape{4, 2}, RowShape{3, 4}, RowShape{8, 4}}) {
        CHECK_THROWS_AS(list.prepare_for(default_simd_level(), shape), ContractViolation);
    }
}

TEST_CASE("wrapping atoms behind the back of the list does no harm") {
    State state = test::random_state(200, Box(Vec3::Constant(5.0)), 97);
    const double skin = GENERATE(0.3, 12.0);  // with a skin beyond 2 L a wrapped atom counts as hardly moved
    VerletList list(skin);
    std::mt19937_64 generator(5);
    for (int step = 0; step < 5; ++step) {
        CHECK(agrees(list, state, 2.5));
        test::displace(state, 0.05, generator);
        state.wrap();
    }
}

TEST_CASE("two lists on one state, and one list on two states, do not mix up") {
    State state = test::random_state(200, Box(Vec3::Constant(6.5)), 101);
    State other = test::random_state(150, Box(Vec3::Constant(6.5)), 103);
    VerletList list(0.3);
    VerletList second(0.5);
    std::mt19937_64 generator(6);
    for (int step = 0; step < 6; ++step) {
        CHECK(agrees(list, state, 2.5));
        CHECK(agrees(second, state, 2.2));
        CHECK(agrees(list, other, 2.5));
        test::displace(state, 0.05, generator);
    }
}

TEST_CASE("a list handles no atom, one and two") {
    const Box box(Vec3::Constant(5.0));
    State nobody(0, box);
    VerletList(0.3).prepare(nobody, 2.5);

    State one = test::random_state(1, box, 1);
    VerletList list(0.3);
    list.prepare(one, 2.5);
    CHECK(test::pairs_within(list, one, 2.5).empty());

    State two = test::state_of({{0.1, 4.9, 2.0}, {4.9, 0.1, 2.0}}, box);
    VerletList pair_list(0.3);
    pair_list.prepare(two, 2.5);
    CHECK(test::pairs_within(pair_list, two, 2.5) == std::vector<test::OrderedPair>{{0, 1}, {1, 0}});
}

TEST_CASE("a list reports a position that is not finite, also between rebuilds") {
    State state = test::random_state(50, Box(Vec3::Constant(5.0)), 107);
    VerletList list(0.3);
    list.prepare(state, 2.5);
    state.write_positions()(2, 7) = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(list.prepare(state, 2.5), PhysicsError);
}

TEST_CASE("a list with a fixed schedule is said to be late when an atom had moved too far at its end") {
    State state = test::random_state(300, Box(Vec3::Constant(7.3)), 71);
    VerletList fixed(0.4, Index{3});
    const auto late_after = [&](const Vec3& d) {
        fixed.prepare(state, 2.5);  // its last use, if it is the third
        move(state, 7, d);
        fixed.prepare(state, 2.5);
        return fixed.statistics().late_rebuilds;
    };
    fixed.prepare(state, 2.5);
    CHECK(late_after(Vec3(0.15, 0.0, 0.0)) == 0);
    CHECK(late_after(Vec3(0.0, 0.3, 0.0)) == 0);  // built before it was moved
    CHECK(fixed.statistics().rebuilds == 2);
    CHECK(late_after(Vec3::Zero()) == 1);
    CHECK(fixed.statistics().rebuilds == 3);
    state.rescale_to(Box(Vec3::Constant(7.4)));  // a list of another box was not late
    fixed.prepare(state, 2.5);
    CHECK(fixed.statistics().rebuilds == 4);
    CHECK(fixed.statistics().late_rebuilds == 1);

    VerletList checked(0.4);
    checked.prepare(state, 2.5);
    move(state, 7, Vec3(3.0, 0.0, 0.0));
    checked.prepare(state, 2.5);
    CHECK(checked.statistics().rebuilds == 2);
    CHECK(checked.statistics().late_rebuilds == 0);
}

TEST_CASE("a list that was archived between rebuilds is the same list, and is rebuilt at the same time") {
    const auto every = GENERATE(std::optional<Index>(), std::optional<Index>(5));
    const Box box(Vec3::Constant(7.3));
    State state = test::random_state(300, box, 71);
    VerletList list(0.4, every);
    std::mt19937_64 generator(3);
    list.prepare(state, 2.5);
    for (int n = 0; n < 2; ++n) {
        test::displace(state, 0.05, generator);
        list.prepare(state, 2.5);
    }
    REQUIRE(list.statistics().rebuilds == 1);

    Archive a;
    list.archive(a, state, 2.5);
    Archive back(a.bytes());
    VerletList other(0.4, every);
    State same = state;
    other.archive(back, same, 2.5);
    back.expect_end();
    CHECK(other.statistics().rebuilds == 1);
    CHECK(other.statistics().preparations == list.statistics().preparations);
    CHECK(same.ids() == state.ids());
    CHECK(same.positions() == state.positions());
    for (int n = 0; n < 12; ++n) {
        CHECK(test::pairs_within(other, same, 2.5) == test::pairs_within(list, state, 2.5));
        std::mt19937_64 one(static_cast<unsigned>(n));
        std::mt19937_64 two(static_cast<unsigned>(n));
        test::displace(state, 0.05, one);
        test::displace(same, 0.05, two);
        list.prepare(state, 2.5);
        other.prepare(same, 2.5);
        CHECK(other.statistics().rebuilds == list.statistics().rebuilds);
        CHECK(same.ids() == state.ids());
    }
    CHECK(list.statistics().rebuilds > 1);
}

TEST_CASE("a list takes nothing from an archive of other atoms") {
    State state = test::random_state(300, Box(Vec3::Constant(7.3)), 71);
    VerletList list(0.4);
    list.prepare(state, 2.5);
    Archive a;
    list.archive(a, state, 2.5);
    State fewer = test::random_state(299, Box(Vec3::Constant(7.3)), 71);
    Archive back(a.bytes());
    CHECK_THROWS_WITH(list.archive(back, fewer, 2.5), Catch::Contains("some of its atoms lack data"));
}
