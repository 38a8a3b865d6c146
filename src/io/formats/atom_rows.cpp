#include "io/formats/atom_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "io/formats/configuration_check.hpp"

namespace ljmd {
Index read_atom_count(TextFile& file, std::string_view field, Index wanted) {
    const Index count = file.integer(field, "the number of atoms");
    if (count < 1) file.fail(fmt::format("the number of atoms must be at least 1, found {}", count));
    if (wanted > 0 && count != wanted) file.fail(fmt::format("{} atoms, but frame 1 has {}", count, wanted));
    file.require_room(count);
    return count;
}

std::size_t expected_atoms(const TextFile& file, Index count) {
    constexpr Index default_shortest_line = 8;  // "1 0 0 0" and the line end
    return static_cast<std::size_t>(std::min(count, file.bytes_left() / default_shortest_line + 1));
}

void next_atom_line(TextFile& file, Index row, Index count) {
    if (!file.next_line()) file.fail(fmt::format("the file ends after {} of {} atoms", row, count));
    if (is_blank(file.line())) file.fail(fmt::format("blank line where atom {} of {} should stand", row + 1, count));
}

Vec3 read_vector(const TextFile& file, const std::vector<std::string_view>& fields, std::size_t first) {
    return {file.number(fields[first], "a coordinate"), file.number(fields[first + 1], "a coordinate"),
            file.number(fields[first + 2], "a coordinate")};
}

Vec3 read_optional_vector(const std::vector<std::string_view>& fields, std::size_t first) {
    return {number_or_nan(fields[first]), number_or_nan(fields[first + 1]), number_or_nan(fields[first + 2])};
}

AtomOrder file_order(Index count, Index first_line) {
    AtomOrder order{{}, std::vector<Index>(static_cast<std::size_t>(count)), first_line};
    std::iota(order.rows.begin(), order.rows.end(), Index{0});
    return order;
}

AtomOrder order_by_id(const TextFile& file, const std::vector<Index>& ids, Index first_line) {
    AtomOrder order = file_order(std::ssize(ids), first_line);
    const auto id_of = [&](Index row) { return ids[static_cast<std::size_t>(row)]; };
    if (!std::ranges::is_sorted(ids)) {
        std::ranges::stable_sort(order.rows, {}, id_of);
    }
    order.ids = arranged(ids, order.rows);
    if (!order.ids.empty() && order.ids[0] < 0) {
        file.fail_at(order.line(0), fmt::format("id {}: ids must not be negative", order.ids[0]));
    }
    const auto same = std::ranges::adjacent_find(order.ids);
    if (same != order.ids.end()) {
        const Index first = same - order.ids.begin();
        file.fail_at(order.line(first + 1),
                     fmt::format("id {} occurs twice, first in line {}", *same, order.line(first)));
    }
    return order;
}

void check_frame(const TextFile& file, const Configuration& configuration, const AtomOrder& order, Index header_line) {
    const auto fault = find_fault(configuration);
    if (!fault) return;
    if (!fault->atom) file.fail_at(header_line, fault->message);
    const std::string words = fmt::format("atom {} {}", order.id(*fault->atom), fault->message);
    if (fault->is_lost) file.fail_as_lost_at(order.line(*fault->atom), words);
    file.fail_at(order.line(*fault->atom), words);
}

void check_configuration(const TextFile& file, const Configuration& configuration, const AtomOrder& order,
                         Index header_line) {
    check_frame(file, configuration, order, header_line);
    if (const auto same = find_coincident_atoms(configuration)) {
        const auto [first, second] = *same;
        file.fail_at(std::max(order.line(first), order.line(second)),
                     fmt::format("atoms {} and {} are at the same place in the periodic box", order.id(first),
                                 order.id(second)));
    }
}

}  // namespace ljmd
