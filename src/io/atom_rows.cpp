#include "ljmd/io/atom_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "ljmd/io/configuration_check.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {
namespace {

/// Where an atom lies in the box, on the box's grid.
Vec3 place_in(const Box& box, const Vec3& position) {
    Vec3 place = box.snap(position - box.crossings(position).cwiseProduct(box.edges()));
    for (int axis = 0; axis < 3; ++axis) {
        // Rounded up to the far wall, which is the image of the near one.
        if (place[axis] == box.edges()[axis]) place[axis] = 0.0;
    }
    return place;
}

/// Compares the places that the atoms will have in the box, on its grid, so that what is told apart here stays apart.
void check_distinct(const TextFile& file, const Configuration& configuration, const AtomOrder& order) {
    const Box box(configuration.edges);
    std::vector<std::array<double, 3>> places;
    places.reserve(configuration.positions.size());
    for (const Vec3& position : configuration.positions) {
        const Vec3 place = place_in(box, position);
        places.push_back({place[0], place[1], place[2]});
    }
    std::vector<std::size_t> sorted(places.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::sort(sorted.begin(), sorted.end(),
              [&](std::size_t a, std::size_t b) { return places[a] != places[b] ? places[a] < places[b] : a < b; });
    const auto same = std::adjacent_find(sorted.begin(), sorted.end(),
                                         [&](std::size_t a, std::size_t b) { return places[a] == places[b]; });
    if (same == sorted.end()) return;
    const auto first = static_cast<Index>(*same);
    const auto second = static_cast<Index>(*std::next(same));
    file.fail_at(
        std::max(order.line(first), order.line(second)),
        fmt::format("atoms {} and {} are at the same place in the periodic box", order.id(first), order.id(second)));
}

}  // namespace

Index read_atom_count(TextFile& file, std::string_view field, Index wanted) {
    const Index count = file.integer(field, "the number of atoms");
    if (count < 1) file.fail(fmt::format("the number of atoms must be at least 1, found {}", count));
    if (wanted > 0 && count != wanted) file.fail(fmt::format("{} atoms, but frame 1 has {}", count, wanted));
    file.require_room(count);
    return count;
}

std::size_t expected_atoms(const TextFile& file, Index count) {
    constexpr Index usual_shortest_line = 8;  // "1 0 0 0" and its end
    return static_cast<std::size_t>(std::min(count, file.bytes_left() / usual_shortest_line + 1));
}

void next_atom_line(TextFile& file, Index row, Index count) {
    if (!file.next_line()) file.fail(fmt::format("the file ends after {} of {} atoms", row, count));
    if (is_blank(file.line())) file.fail(fmt::format("blank line where atom {} of {} should stand", row + 1, count));
}

Vec3 read_vector(const TextFile& file, const std::vector<std::string_view>& fields, std::size_t first) {
    return {file.number(fields[first], "a coordinate"), file.number(fields[first + 1], "a coordinate"),
            file.number(fields[first + 2], "a coordinate")};
}

AtomOrder file_order(Index count, Index first_line) {
    AtomOrder order{1, std::vector<Index>(static_cast<std::size_t>(count)), first_line};
    std::iota(order.rows.begin(), order.rows.end(), Index{0});
    return order;
}

AtomOrder order_by_id(const TextFile& file, const std::vector<Index>& ids, Index first_line) {
    constexpr Index none = -1;
    const auto count = static_cast<Index>(ids.size());
    const Index first_id = std::find(ids.begin(), ids.end(), 0) == ids.end() ? 1 : 0;
    AtomOrder order{first_id, std::vector<Index>(ids.size(), none), first_line};
    for (Index row = 0; row < count; ++row) {
        const Index id = ids[static_cast<std::size_t>(row)];
        if (id < first_id || id >= first_id + count) {
            file.fail_at(first_line + row, fmt::format("id {} is not among the ids of {} atoms, {} to {}", id, count,
                                                       first_id, first_id + count - 1));
        }
        Index& place = order.rows[static_cast<std::size_t>(id - first_id)];
        if (place != none) {
            file.fail_at(first_line + row, fmt::format("id {} occurs twice, first in line {}", id, first_line + place));
        }
        place = row;
    }
    return order;
}

void check_frame(const TextFile& file, const Configuration& configuration, const AtomOrder& order, Index header_line) {
    const auto fault = find_fault(configuration);
    if (!fault) return;
    if (!fault->atom) file.fail_at(header_line, fault->message);
    file.fail_at(order.line(*fault->atom), fmt::format("atom {} {}", order.id(*fault->atom), fault->message));
}

void check_configuration(const TextFile& file, const Configuration& configuration, const AtomOrder& order,
                         Index header_line) {
    check_frame(file, configuration, order, header_line);
    check_distinct(file, configuration, order);
}

}  // namespace ljmd
