#include "neighbors/column_sort.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/resize_tightly.hpp"
#include "execution/loops.hpp"
#include "neighbors/cluster_grid.hpp"

namespace ljmd {

namespace {

struct HeightKey {
    double z;
    Index id;
    Index atom;
};

}  // namespace

void ColumnSort::sort(const State& atoms, std::size_t columns, const FindColumns& find) {
    // A counting sort of equal shares of the atoms. Within a column their order does not matter yet.
    const Index count = atoms.count();
    const Index shares = atoms.execution().threads();
    const Index share = std::max<Index>(1, (count + shares - 1) / shares);
    resize_tightly(column_, static_cast<std::size_t>(count));
    resize_tightly(order_, column_.size());
    next_.assign(static_cast<std::size_t>(shares) * columns, 0);
    const auto next_of = [&](Index first) { return next_.data() + static_cast<std::size_t>(first / share) * columns; };
    for_each_block(atoms.execution(), count, share, [&](Index first, Index last) {
        find(first, last, column_.data());
        std::uint32_t* counts = next_of(first);
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
            ++counts[column_[i]];
        }
    });
    first_atoms_.resize(columns + 1);
    std::uint32_t sum = 0;
    for (std::size_t c = 0; c < columns; ++c) {
        first_atoms_[c] = sum;
        for (std::size_t n = c; n < next_.size(); n += columns) {
            const std::uint32_t number = next_[n];
            next_[n] = sum;
            sum += number;
        }
    }
    first_atoms_[columns] = sum;
    for_each_block(atoms.execution(), count, share, [&](Index first, Index last) {
        std::uint32_t* next = next_of(first);
        for (Index i = first; i < last; ++i) {
            order_[next[column_[static_cast<std::size_t>(i)]]++] = i;
        }
    });
    for_each_block(atoms.execution(), static_cast<Index>(columns), ClusterGrid::columns_per_block,
                   [&](Index first, Index last) {
                       for (Index column = first; column < last; ++column) {
                           sort_column(atoms, static_cast<std::size_t>(column));
                       }
                   });
}

void ColumnSort::sort_column(const State& atoms, std::size_t column) {
    const auto r = atoms.positions();
    const auto begin = order_.begin() + first_atoms_[column];
    const auto end = order_.begin() + first_atoms_[column + 1];
    thread_local std::vector<HeightKey> keys;
    keys.clear();
    std::transform(begin, end, std::back_inserter(keys), [&](Index i) {
        return HeightKey{r(2, i), atoms.ids()[static_cast<std::size_t>(i)], i};
    });
    const auto is_below = [](const HeightKey& a, const HeightKey& b) {
        return std::tie(a.z, a.id) < std::tie(b.z, b.id);
    };
    std::sort(keys.begin(), keys.end(), is_below);
    std::transform(keys.begin(), keys.end(), begin, [](const HeightKey& key) { return key.atom; });
}

}  // namespace ljmd
