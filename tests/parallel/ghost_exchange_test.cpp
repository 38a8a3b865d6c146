#include "ljmd/parallel/ghost_exchange.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

using Place = std::array<double, 3>;

Place place(const Vec3& r) {
    return {r[0], r[1], r[2]};
}

std::vector<Place> sorted(std::vector<Place> places) {
    std::sort(places.begin(), places.end());
    return places;
}

std::vector<Place> ghosts_of(const State& state) {
    std::vector<Place> places;
    for (Index k = 0; k < state.ghost_count(); ++k) {
        places.push_back(place(state.positions_and_ghosts().col(state.count() + k)));
    }
    return sorted(places);
}

/// Every image but the atom itself inside [-halo, L + halo), from all combinations of up to `reach` edges.
std::vector<Place> images_by_brute_force(const State& state, double halo, int reach) {
    const Vec3& edges = state.box().edges();
    std::vector<Place> places;
    for (Index i = 0; i < state.count(); ++i) {
        for (int x = -reach; x <= reach; ++x) {
            for (int y = -reach; y <= reach; ++y) {
                for (int z = -reach; z <= reach; ++z) {
                    const Vec3 r = state.positions().col(i) + Vec3(x, y, z).cwiseProduct(edges);
                    const bool inside = (r.array() >= -halo).all() && (r.array() < edges.array() + halo).all();
                    if (inside && (x != 0 || y != 0 || z != 0)) {
                        places.push_back(place(r));
                    }
                }
            }
        }
    }
    return sorted(places);
}

}  // namespace

TEST_CASE("every image within the halo is a ghost exactly once, whatever halo and box") {
    const Vec3 edges = GENERATE(Vec3(5.0, 5.0, 5.0), Vec3(3.1, 4.7, 11.3));
    const double halo = GENERATE(1e-9, 0.3, 1.6, 2.5, 3.1, 4.0, 5.0, 6.3, 7.9);  // L/2 = 2.5 or 1.55, L = 5 or 3.1
    const State random = test::random_state(40, Box(edges), 7);
    State state = random;
    GhostExchange().create(state, halo);
    CAPTURE(edges.transpose(), halo);
    CHECK(ghosts_of(state) == images_by_brute_force(random, halo, 4));
    CHECK(state.positions() == random.positions());
    CHECK(state.ids() == random.ids());
}

TEST_CASE("the halo holds its lower end and not its upper one") {
    // By hand, L = 4, halo = 1: images along x of x = 3 at -1 (in), of x = 1 at 5 (out), of x = 0 at 4 (in).
    State state = test::state_of({{3.0, 2.0, 2.0}, {1.0, 2.0, 2.0}, {0.0, 2.0, 2.0}}, Box(Vec3::Constant(4.0)));
    GhostExchange().create(state, 1.0);
    CHECK(ghosts_of(state) == std::vector<Place>{{-1.0, 2.0, 2.0}, {4.0, 2.0, 2.0}});
}

TEST_CASE("an atom in a corner has images across faces, edges and the corner") {
    State state = test::state_of({Vec3::Zero()}, Box(Vec3::Constant(4.0)));
    GhostExchange().create(state, 1.0);
    CHECK(state.ghost_count() == 7);
}

TEST_CASE("an atom in the middle of a large box has no images") {
    State state = test::state_of({Vec3::Constant(2.0)}, Box(Vec3::Constant(4.0)));
    GhostExchange ghosts;
    ghosts.create(state, 1.0);
    CHECK(state.ghost_count() == 0);
    CHECK(ghosts.count() == 0);
}

TEST_CASE("ghosts follow their atoms to the last bit") {
    const double halo = GENERATE(1.0, 3.5, 8.0);
    const Box box(Vec3(4.3, 5.1, 6.7));
    State state = test::random_state(60, box, 3);
    GhostExchange ghosts;
    ghosts.create(state, halo);
    CHECK(ghosts.count() == state.ghost_count());

    // Who belongs to whom, and by how many edges, from the positions at the start.
    struct Image {
        Index owner;
        Vec3 edges;
    };
    std::vector<Image> images;
    const Eigen::Matrix3Xd start = state.positions_and_ghosts();
    for (Index k = state.count(); k < start.cols(); ++k) {
        for (Index i = 0; i < state.count(); ++i) {
            const Vec3 n = (start.col(k) - start.col(i)).cwiseQuotient(box.edges()).array().round();
            if (start.col(k) == start.col(i) + n.cwiseProduct(box.edges())) {
                images.push_back({i, n});
            }
        }
    }
    REQUIRE(static_cast<Index>(images.size()) == state.ghost_count());

    std::mt19937_64 generator(11);
    for (int step = 0; step < 20; ++step) {
        test::displace(state, 0.05, generator);  // atoms leave the box
        ghosts.update(state);
        const auto all = static_cast<const State&>(state).positions_and_ghosts();
        bool exact = true;
        for (std::size_t k = 0; k < images.size(); ++k) {
            const Vec3 shift = images[k].edges.cwiseProduct(box.edges());
            const Vec3 ghost = all.col(state.count() + static_cast<Index>(k));
            exact = exact && ghost == all.col(images[k].owner) + shift && ghost - shift == all.col(images[k].owner);
        }
        CHECK(exact);
    }
}

TEST_CASE("ghosts leave the forces current and are replaced by the next ones") {
    State state = test::random_state(40, Box(Vec3::Constant(5.0)), 5);
    GhostExchange ghosts;
    state.mark_forces_current();
    ghosts.create(state, 2.0);
    const Index many = state.ghost_count();
    ghosts.create(state, 0.5);
    CHECK(state.forces_are_current());
    CHECK(state.ghost_count() < many);
    CHECK(ghosts_of(state) == images_by_brute_force(state, 0.5, 1));
}

TEST_CASE("a box without atoms has no ghosts") {
    State state(0, Box(Vec3::Constant(5.0)));
    GhostExchange().create(state, 2.0);
    CHECK(state.ghost_count() == 0);
}
