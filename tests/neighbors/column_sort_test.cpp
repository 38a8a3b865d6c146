#include "neighbors/column_sort.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

constexpr std::size_t columns = 37;

std::uint32_t column_of(const State& state, Index i) {
    const double along = static_cast<const State&>(state).positions()(0, i) / state.box().edges()[0];
    return static_cast<std::uint32_t>(along * (columns - 1));  // nothing in the last column
}

/// The same by comparing all keys.
std::vector<Index> expected_order(const State& state) {
    std::vector<Index> order(static_cast<std::size_t>(state.count()));
    for (std::size_t k = 0; k < order.size(); ++k) {
        order[k] = static_cast<Index>(k);
    }
    const auto r = state.positions();
    const auto key = [&](Index i) {
        return std::tuple(column_of(state, i), r(2, i), state.ids()[static_cast<std::size_t>(i)]);
    };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    return order;
}

void find(const State& state, ColumnSort& sort) {
    sort.sort(state, columns, [&](Index first, Index last, std::uint32_t* column) {
        for (Index i = first; i < last; ++i) {
            column[i] = column_of(state, i);
        }
    });
}

}  // namespace

TEST_CASE("atoms are sorted by column, height and id, in the same order by any number of threads") {
    ColumnSort sort;
    for (const Index atoms : {0, 1, 2, 5, 1000}) {
        for (const int threads : {1, 2, 3}) {
            CAPTURE(atoms, threads);
            State state = test::random_state(atoms, cubic_box(1000, 0.8), 5, test::with_threads(threads));
            {
                auto r = state.write_positions();
                for (Index i = 0; i < atoms; ++i) {
                    r(2, i) = static_cast<double>(static_cast<int>(r(2, i)));  // many at the same height
                }
            }
            std::vector<Index> turned(static_cast<std::size_t>(atoms));
            for (std::size_t k = 0; k < turned.size(); ++k) {
                turned[k] = static_cast<Index>(turned.size() - 1 - k);
            }
            state.reorder(turned);  // ids are not indices
            find(state, sort);
            CHECK(sort.order() == expected_order(state));
            REQUIRE(sort.first_atoms().size() == columns + 1);
            CHECK(sort.first_atoms().front() == 0);
            CHECK(sort.first_atoms().back() == static_cast<std::uint32_t>(atoms));
            for (std::size_t c = 0; c < columns; ++c) {
                for (std::uint32_t k = sort.first_atoms()[c]; k < sort.first_atoms()[c + 1]; ++k) {
                    CHECK(column_of(state, sort.order()[k]) == c);
                }
            }
        }
    }
}
