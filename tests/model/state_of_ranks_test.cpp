#include <algorithm>
#include <mutex>
#include <optional>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/model/lattice.hpp"
#include "model/shared_state.hpp"

using namespace ljmd;
using test::RankTeam;
using test::same_atoms;

namespace {

const Box box = cubic_box(100, 0.8);

std::vector<Vec3> places(Index atoms) {
    return random_positions(atoms, box, 3);
}

/// Give each atom properties that follow from its id.
void set_properties(State& state) {
    const std::size_t memory = state.register_vectors("memory");
    auto v = state.write_velocities();
    auto f = state.write_forces();
    auto m = state.registered(memory);
    for (Index i = 0; i < state.count(); ++i) {
        const auto id = static_cast<double>(state.ids()[static_cast<std::size_t>(i)]);
        v.col(i) << id, 0.5, -id;
        f.col(i) << 1.0, id, 3.0;
        m.col(i) << 0.25 * id, 1.0, 2.0;
        state.write_masses()[static_cast<std::size_t>(i)] = 1.0 + id;
        state.set_image(i, Eigen::Vector3i(static_cast<int>(id), -1, 2));
    }
    state.time = 2.5;
    state.step = 7;
    state.bath = {1.0, 2.0};
    state.mark_forces_current();
}

State whole(const std::vector<Vec3>& positions) {
    State state = test::share_of(positions, box, nullptr);
    set_properties(state);
    return state;
}

}  // namespace

TEST_CASE("ranks have even shares of the ids, and gathered they have all") {
    const auto positions = places(100);
    const State expected = whole(positions);
    const int size = GENERATE(1, 2, 3, 7);
    std::mutex mutex;
    std::optional<State> found;
    Index elsewhere = 0;
    bool totals = true;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        const bool is_root = ranks->is_root();
        State state = test::share_of(positions, box, std::move(ranks));
        set_properties(state);
        State all = state.gathered();
        const std::lock_guard lock(mutex);
        totals = totals && state.total() == 100 && state.count() >= 100 / size;
        if (is_root) {
            found = std::move(all);
        } else {
            elsewhere += all.count();
        }
    });
    REQUIRE(found);
    CHECK(totals);
    CHECK(elsewhere == 0);
    CHECK(same_atoms(*found, expected));
    CHECK(found->execution().ranks().alone());
    CHECK(found->time == 2.5);
    CHECK(found->step == 7);
    CHECK(found->bath == expected.bath);
    CHECK(std::as_const(*found).registered(0) == std::as_const(expected).registered(0));
}

TEST_CASE("an atom takes all its properties to another rank") {
    const auto positions = places(60);
    const State expected = whole(positions);
    const int size = GENERATE(1, 2, 5);
    std::mutex mutex;
    std::optional<State> found;
    bool right = true;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        const int rank = ranks->rank();
        State state = test::share_of(positions, box, std::move(ranks));
        set_properties(state);
        const Index order = state.order_version();
        std::vector<int> destinations;
        for (const Index id : state.ids()) {
            destinations.push_back(static_cast<int>(id * id) % size);
        }
        state.migrate(destinations);
        bool here = state.order_version() > order;
        for (const Index id : state.ids()) {
            here = here && static_cast<int>(id * id) % size == rank;
        }
        State all = state.gathered();
        const std::lock_guard lock(mutex);
        right = right && here;
        if (rank == 0) {
            found = std::move(all);
        }
    });
    CHECK(right);
    REQUIRE(found);
    std::vector<Index> by_id = found->index_of();
    found->reorder(by_id);
    CHECK(same_atoms(*found, expected));
    CHECK(std::as_const(*found).registered(0) == std::as_const(expected).registered(0));
}

TEST_CASE("an archive has the same bytes whoever wrote it, and any number of ranks reads it") {
    const auto positions = places(50);
    State expected = whole(positions);
    Archive one;
    expected.archive(one);
    const int size = GENERATE(2, 3);
    std::mutex mutex;
    std::vector<std::byte> written;
    std::size_t of_others = 0;
    std::optional<State> read;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        const bool is_root = ranks->is_root();
        State state = test::share_of(positions, box, ranks);
        set_properties(state);
        Archive a;
        state.archive(a);
        State empty(50, box, Execution(ExecutionOptions{.ranks = std::move(ranks)}));
        Archive from(one.bytes());
        empty.archive(from);
        from.expect_end();
        State all = empty.gathered();
        const std::lock_guard lock(mutex);
        if (is_root) {
            written.assign(a.bytes().begin(), a.bytes().end());
            read = std::move(all);
        } else {
            of_others += a.bytes().size();
        }
    });
    CHECK(std::equal(written.begin(), written.end(), one.bytes().begin(), one.bytes().end()));
    CHECK(of_others == 0);
    REQUIRE(read);
    CHECK(same_atoms(*read, expected));
    CHECK(read->step == 7);
}

TEST_CASE("one rank of several does not know where each atom is") {
    CHECK_THROWS_AS(RankTeam(2).run([](std::shared_ptr<Ranks> ranks) {
        const State state(10, box, Execution(ExecutionOptions{.ranks = std::move(ranks)}));
        static_cast<void>(state.index_of());
    }),
                    ContractViolation);
}

TEST_CASE("an atom that has left is named by all ranks alike") {
    const auto positions = places(20);
    const int size = GENERATE(1, 3);
    std::mutex mutex;
    std::vector<std::string> said;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        State state = test::share_of(positions, box, std::move(ranks));
        for (Index i = 0; i < state.count(); ++i) {
            if (state.ids()[static_cast<std::size_t>(i)] == 13) {
                state.write_positions()(1, i) = 1e9 * box.edges()[1];
            }
        }
        try {
            state.wrap();
        } catch (const PhysicsError& error) {
            const std::lock_guard lock(mutex);
            said.emplace_back(error.what());
        }
    });
    REQUIRE(said.size() == static_cast<std::size_t>(size));
    CHECK(std::all_of(said.begin(), said.end(), [&](const std::string& each) {
        return each == said.front() && each.find("atom 14 has left its box") == 0;
    }));
}
