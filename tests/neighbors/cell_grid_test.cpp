#include "neighbors/cell_grid.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/ghost_exchange.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

/// How often a grid yields each point for one atom.
std::vector<int> times_met(const CellGrid& grid, const State& state, Index i) {
    std::vector<int> times(static_cast<std::size_t>(state.positions_and_ghosts().cols()));
    grid.for_each_run(grid.cell_at(state.positions().col(i)), [&](CellGrid::Run run) {
        for (std::int32_t k = run.first; k < run.last; ++k) {
            ++times[static_cast<std::size_t>(grid.order()[static_cast<std::size_t>(k)])];
        }
    });
    return times;
}

CellGrid filled(State& state, double range) {
    CellGrid grid;
    grid.configure(state.box(), range, state.count());
    GhostExchange ghosts;
    grid.sort(state, ghosts);
    return grid;
}

/// No point within range of an atom is missing, none is met twice.
bool finds_everything(const State& state, const CellGrid& grid, double range) {
    const auto all = state.positions_and_ghosts();
    for (Index i = 0; i < state.count(); ++i) {
        const std::vector<int> met = times_met(grid, state, i);
        for (Index j = 0; j < all.cols(); ++j) {
            const int times = met[static_cast<std::size_t>(j)];
            const bool near = (all.col(i) - all.col(j)).norm() <= range;
            if (times > 1 || (near && times == 0)) {
                return false;
            }
        }
    }
    return true;
}

double candidates_per_atom(const State& state, const CellGrid& grid) {
    std::int64_t candidates = 0;
    for (Index i = 0; i < state.count(); ++i) {
        grid.for_each_run(grid.cell_at(state.positions().col(i)),
                          [&](CellGrid::Run run) { candidates += run.length(); });
    }
    return static_cast<double>(candidates) / static_cast<double>(state.count());
}

}  // namespace

TEST_CASE("the cells around an atom hold all points within range, each once") {
    const Vec3 edges = GENERATE(Vec3(5.0, 5.0, 5.0), Vec3(6.1, 6.1, 6.1), Vec3(4.2, 19.0, 7.7), Vec3(40.0, 5.0, 5.0));
    const double range = GENERATE(0.9, 2.1, 2.5, 2.8, 5.0, 9.0);
    const Index atoms = GENERATE(Index{3}, Index{150});
    CAPTURE(edges.transpose(), range, atoms);
    State state = test::random_state(atoms, Box(edges), 17);
    const CellGrid grid = filled(state, range);
    CHECK(finds_everything(state, grid, range));
}

TEST_CASE("atoms on the walls of cells, and a hair beside them, are found") {
    // Cells of width 1.25 in a box of 5: everything lies on the walls, where rounding decides about the cell.
    const Box box(Vec3::Constant(5.0));
    const double range = 2.5;
    State state = test::crystal_state(Lattice::simple_cubic, 4, box);
    const double hair = GENERATE(0.0, 1.0, -1.0);
    const auto r = state.write_positions();
    for (Index i = 0; i < state.count(); i += 3) {
        state.write_positions().col(i) = (r.col(i).array() + hair * box.resolution()).max(0.0);
    }
    CHECK(finds_everything(state, filled(state, range), range));
}

TEST_CASE("an atom on the last grid point before the far wall is found and finds") {
    const Box box(Vec3(5.0, 5.3, 7.1));
    const double last = box.resolution();
    State state = test::state_of({box.edges() - Vec3::Constant(last), Vec3::Zero(), Vec3(2.4, 0.0, 0.0)}, box);
    CHECK(finds_everything(state, filled(state, 2.5), 2.5));
}

TEST_CASE("every image within range of the box is a ghost exactly once, whatever range and box") {
    const Vec3 edges = GENERATE(Vec3(5.0, 5.0, 5.0), Vec3(3.1, 4.7, 11.3));
    const double range = GENERATE(0.3, 1.6, 2.5, 3.1, 4.0, 5.0, 6.3, 7.9);  // L/2 = 2.5 or 1.55, L = 5 or 3.1
    CAPTURE(edges.transpose(), range);
    const Box box(edges);
    State state = test::random_state(40, box, 7);
    const CellGrid grid = filled(state, range);

    std::vector<std::array<double, 3>> ghosts;
    const auto all = static_cast<const State&>(state).positions_and_ghosts();
    for (Index k = state.count(); k < all.cols(); ++k) {
        ghosts.push_back({all(0, k), all(1, k), all(2, k)});
    }
    std::sort(ghosts.begin(), ghosts.end());
    CHECK(std::adjacent_find(ghosts.begin(), ghosts.end()) == ghosts.end());

    std::size_t images = 0;
    bool complete = true;
    constexpr int reach = 5;
    for (Index i = 0; i < state.count(); ++i) {
        for (int x = -reach; x <= reach; ++x) {
            for (int y = -reach; y <= reach; ++y) {
                for (int z = -reach; z <= reach; ++z) {
                    const Vec3 r = all.col(i) + Vec3(x, y, z).cwiseProduct(box.edges());
                    const bool found = std::binary_search(ghosts.begin(), ghosts.end(), std::array{r[0], r[1], r[2]});
                    const bool inside = (r.array() >= -range).all() && (r.array() < box.edges().array() + range).all();
                    const bool image = x != 0 || y != 0 || z != 0;
                    images += found && image ? 1 : 0;
                    complete = complete && (found || !image || !inside);
                }
            }
        }
    }
    CHECK(complete);
    CHECK(images == ghosts.size());  // there is nothing else among them
}

TEST_CASE("candidates per atom do not grow with the number of atoms") {
    // 6, 12 and 18 cells along the edges: the neighbourhoods are alike.
    const double density = 0.8442;
    const double range = cubic_box(500, density).edges()[0] / 3.0 * (1.0 - 1e-6);
    double smallest = 1e300;
    double largest = 0.0;
    for (const Index cells : {5, 10, 15}) {
        const Index atoms = lattice_atoms(Lattice::fcc, cells);
        State state = test::random_state(atoms, cubic_box(atoms, density), 23);
        const double candidates = candidates_per_atom(state, filled(state, range));
        smallest = std::min(smallest, candidates);
        largest = std::max(largest, candidates);
    }
    CHECK(largest < 1.03 * smallest);
    CHECK(largest < 1.03 * density * std::pow(2.5 * range, 3));  // 5 cells of half the range along each axis
}

TEST_CASE("a nearly empty box is cut into few cells") {
    State state = test::random_state(8, Box(Vec3::Constant(1000.0)), 2);
    const CellGrid grid = filled(state, 2.5);
    CHECK(grid.run_count() == 9);  // cells wider than the range: one to each side
    CHECK(finds_everything(state, grid, 2.5));
}

TEST_CASE("atoms are sorted by cell and by id within it, and no present order changes that") {
    State state = test::random_state(400, Box(Vec3(8.0, 7.0, 9.0)), 31);
    const auto ids_in_order = [](State atoms) {
        const CellGrid grid = filled(atoms, 2.5);
        return atoms.ids();
    };
    const std::vector<Index> expected = ids_in_order(state);
    CHECK(std::set<Index>(expected.begin(), expected.end()).size() == 400);
    CHECK(expected != state.ids());

    std::vector<Index> shuffle(400);
    std::iota(shuffle.begin(), shuffle.end(), Index{0});
    std::shuffle(shuffle.begin(), shuffle.end(), std::mt19937_64(5));
    state.reorder(shuffle);
    CHECK(ids_in_order(state) == expected);

    // Atoms of the same cell follow each other with ascending ids; cells follow each other along x, then y, then z.
    const CellGrid grid = filled(state, 2.5);
    const Vec3 cells(6.0, 5.0, 7.0);  // floor(2 L / range)
    const auto cell_of = [&](Index i) {
        const Vec3 c = state.positions().col(i).cwiseQuotient(state.box().edges()).cwiseProduct(cells).array().floor();
        return (c[2] * cells[1] + c[1]) * cells[0] + c[0];
    };
    bool ascending = true;
    for (Index i = 1; i < state.count(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        ascending = ascending && (cell_of(i - 1) < cell_of(i) ||
                                  (cell_of(i - 1) == cell_of(i) && state.ids()[k - 1] < state.ids()[k]));
    }
    CHECK(ascending);
}

TEST_CASE("a grid is usable again after another box, range and number of atoms") {
    CellGrid grid;
    GhostExchange ghosts;
    for (const double edge : {12.0, 5.0, 9.0}) {
        State state = test::random_state(static_cast<Index>(edge * 10), Box(Vec3::Constant(edge)), 3);
        grid.configure(state.box(), 2.2, state.count());
        grid.sort(state, ghosts);
        CHECK(finds_everything(state, grid, 2.2));
    }
}
