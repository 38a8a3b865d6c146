#include "model/atoms_by_id.hpp"

#include <mutex>
#include "catch.hpp"

#include "execution/rank_team.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/model/lattice.hpp"
#include "model/shared_state.hpp"

using namespace ljmd;
using test::RankTeam;

namespace {

const Box long_box(Vec3(7.0, 8.0, 9.0));
constexpr Index atoms = 50;

/// Different numbers for each atom and property.
void set_all(State& state) {
    auto v = state.write_velocities();
    for (Index i = 0; i < state.count(); ++i) {
        const auto id = static_cast<double>(state.ids()[static_cast<std::size_t>(i)]);
        v.col(i) = Vec3(id, 0.5 * id, -id);
        state.write_masses()[static_cast<std::size_t>(i)] = 1.0 + id;
        state.set_image(i, {static_cast<int>(id), -1, 2});
    }
    auto f = state.write_forces();
    for (Index i = 0; i < state.count(); ++i) {
        f.col(i) = Vec3::Constant(100.0 + static_cast<double>(state.ids()[static_cast<std::size_t>(i)]));
    }
}

/// All pieces end to end, and their lengths.
struct Seen {
    std::vector<Vec3> positions;
    std::vector<Vec3> unwrapped;
    std::vector<Vec3> velocities;
    std::vector<Vec3> forces;
    std::vector<double> masses;
    std::vector<Index> lengths;

    explicit Seen(const State& state, Index atoms_of_piece) {
        const AtomParts all{.positions = true, .velocities = true, .forces = true, .masses = true};
        const auto append = [](auto& list, const auto& more) { list.insert(list.end(), more.begin(), more.end()); };
        visit_by_id(
            state, all,
            [&](const AtomPiece& piece) {
                CHECK(piece.first == std::ssize(positions));
                append(positions, piece.positions);
                append(unwrapped, piece.unwrapped(state));
                append(velocities, piece.velocities);
                append(forces, piece.forces);
                append(masses, piece.masses);
                lengths.push_back(piece.count);
            },
            atoms_of_piece);
    }
    bool operator==(const Seen&) const = default;
};

}  // namespace

TEST_CASE("atoms come in the order of ids, in pieces, with what was asked for") {
    State state = test::share_of(random_positions(atoms, long_box, 3), long_box, nullptr);
    set_all(state);
    std::vector<Index> backwards;
    for (Index i = atoms; i-- > 0;) {
        backwards.push_back(i);
    }
    state.reorder(backwards);
    set_all(state);
    const Seen seen(state, 15);
    CHECK(seen.lengths == std::vector<Index>{15, 15, 15, 5});
    const std::vector<Vec3> expected = random_positions(atoms, long_box, 3);
    CHECK(seen.positions == expected);
    CHECK(seen.unwrapped[3] == expected[3] + Vec3(21.0, -8.0, 18.0));
    CHECK(seen.velocities[7] == Vec3(7.0, 3.5, -7.0));
    CHECK(seen.forces[7] == Vec3::Constant(107.0));
    CHECK(seen.masses[49] == 50.0);
    visit_by_id(state, {.masses = true}, [](const AtomPiece& piece) {
        CHECK(piece.count == atoms);
        CHECK(piece.positions.empty());
        CHECK(piece.forces.empty());
        CHECK(piece.masses.size() == atoms);
    });
}

TEST_CASE("of several ranks the first one sees the atoms of all, as often as it likes") {
    const auto positions = random_positions(atoms, long_box, 3);
    State whole = test::share_of(positions, long_box, nullptr);
    set_all(whole);
    const Seen expected(whole, 15);
    const int size = GENERATE(2, 3, 7);
    std::mutex mutex;
    int looked = 0;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        State state = test::share_of(positions, long_box, std::move(ranks));
        set_all(state);
        look_by_id(state, [&] {
            const Seen once(state, 15);
            const State all = gathered_for_root(state);
            const Seen again(state, 15);
            const std::lock_guard lock(mutex);
            CHECK(once == expected);
            CHECK(again == expected);
            CHECK(all.count() == atoms);
            ++looked;
        });
    });
    CHECK(looked == 1);
}

TEST_CASE("a failure while atoms are looked at leaves the ranks in step") {
    const auto positions = random_positions(atoms, long_box, 3);
    std::mutex mutex;
    Index seen = 0;
    RankTeam(3).run([&](std::shared_ptr<Ranks> ranks) {
        const State state = test::share_of(positions, long_box, std::move(ranks));
        look_by_id(state, [&] {
            const std::lock_guard lock(mutex);
            CHECK_THROWS_AS(visit_by_id(
                                state, {.positions = true}, [](const AtomPiece&) { throw FileError("full"); }, 10),
                            FileError);
            visit_by_id(state, {.positions = true}, [&](const AtomPiece& piece) { seen += piece.count; });
        });
    });
    CHECK(seen == atoms);
}
