#include "neighbors/pair_search.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

std::vector<test::OrderedPair> pairs_of(const std::string& method, double skin, State state, double cutoff) {
    PairSearch any = make_pair_search(method, skin);
    return std::visit(
        [&](auto& search) {
            search.prepare(state, cutoff);
            return test::pairs_within(search, state, cutoff);
        },
        any);
}

}  // namespace

TEST_CASE("every pair search that is listed can be made, and has the name it is listed under") {
    CHECK(pair_search_names() == std::vector<std::string>{"verlet-list", "cells", "all-pairs"});
    for (const std::string& name : pair_search_names()) {
        const PairSearch any = make_pair_search(name, 0.3);
        CHECK(std::visit([](const auto& search) { return std::string(search.name); }, any) == name);
    }
    CHECK(std::get<VerletList>(make_pair_search("verlet-list", 0.7)).skin() == 0.7);
}

TEST_CASE("an unknown pair search is refused with the names there are") {
    CHECK_THROWS_AS(make_pair_search("octree", 0.3), InputError);
    CHECK_THROWS_WITH(make_pair_search("octree", 0.3),
                      Catch::Contains("octree") && Catch::Contains("verlet-list, cells, all-pairs"));
}

TEST_CASE("every search finds the same ordered pairs, once each, whatever the order in memory") {
    const double density = GENERATE(0.05, 0.6, 1.2);
    const Box box(Vec3(5.0, 5.8, 12.4));
    const auto atoms = static_cast<Index>(density * box.volume());
    State state = test::random_state(atoms, box, 109);
    const auto expected = pairs_of("all-pairs", 0.0, state, 2.5);
    CHECK(std::adjacent_find(expected.begin(), expected.end()) == expected.end());
    std::vector<Index> order(static_cast<std::size_t>(atoms));
    for (std::size_t k = 0; k < order.size(); ++k) {
        order[k] = static_cast<Index>((k + order.size() / 3) % order.size());
    }
    State rotated = state;
    rotated.reorder(order);
    for (const std::string& name : pair_search_names()) {
        for (const double skin : {0.0, 0.3, 1.0}) {
            CAPTURE(name, skin, density);
            CHECK(pairs_of(name, skin, state, 2.5) == expected);
            CHECK(pairs_of(name, skin, rotated, 2.5) == expected);
        }
    }
}

TEST_CASE("an order by cells and ids does not depend on the order before") {
    const std::string name = GENERATE("verlet-list", "cells");
    State state = test::random_state(300, Box(Vec3::Constant(7.0)), 113);
    State reversed = state;
    std::vector<Index> order(300);
    for (std::size_t k = 0; k < order.size(); ++k) {
        order[k] = static_cast<Index>(order.size() - 1 - k);
    }
    reversed.reorder(order);
    const auto prepare = [&](State& atoms) {
        PairSearch any = make_pair_search(name, 0.3);
        std::visit([&](auto& search) { search.prepare(atoms, 2.5); }, any);
    };
    prepare(state);
    prepare(reversed);
    CHECK(state.ids() == reversed.ids());
    CHECK(static_cast<const State&>(state).positions_and_ghosts() ==
          static_cast<const State&>(reversed).positions_and_ghosts());
}
