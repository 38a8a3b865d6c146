// How a fluid of even density is shared among ranks: for each number of ranks one line of JSON, with the tiles, and for
// each of some ranks atoms, those of them in tiles without ghosts of other ranks ("inner"), ghosts, messages and pairs
// on its lists.
//
//     decomposition [--messages] ATOMS DENSITY CUTOFF SKIN RANKS...
//
// No atom is made: the program asks the grid of the neighbour list (ClusterGrid), as it does in a run, which tiles a
// rank has and what it takes of others. Of more than 24 ranks with the most tiles, for which a run waits, 24 are asked,
// evenly spaced; with --messages all ranks are, and the "parts" of each are [other rank, atoms whose positions come
// from it, atoms whose forces go to it].

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <numbers>
#include <string_view>

#include "ljmd/model/lattice.hpp"
#include "neighbors/cluster_grid.hpp"

namespace {

using namespace ljmd;

/// A rank that knows its number, and has nobody to talk to.
class LoneRank : public Ranks {
  public:
    LoneRank(int rank, int size) : Ranks(rank, size) {}
    void sum(std::span<std::int64_t>) override { refuse(); }
    void largest(std::span<double>) override { refuse(); }
    std::vector<Bytes> exchange(std::vector<Bytes>) override { refuse(); }
    void begin_exchange(std::span<const Outgoing>, std::span<const Incoming>) override { refuse(); }
    void finish_exchange() override { refuse(); }
    void abandon(int) override { refuse(); }

  private:
    [[noreturn]] static void refuse() { std::abort(); }
};

struct Fluid {
    Index atoms;
    double density;
    double cutoff;
    double skin;
};

/// Of a column that is cut off between clusters, 0 to 3 atoms more than the volume has are taken, all as often.
double atoms_in(const ClusterGrid::HaloPart& part, double density) {
    return density * part.volume + 0.5 * (ClusterGrid::slots - 1) * static_cast<double>(part.cuts);
}

/// Points a and b, one in each of two tiles, less than `range` apart: the integral over both [sigma^6]; of a tile with
/// itself each pair once. Over an octant of the ball the integrals of 1, x, xy and xyz are pi R^3/6, pi R^4/16, R^5/15
/// and R^6/48. @param away  tiles between them along each axis, -1, 0 or 1  @pre no edge of a tile is below the range
double pair_volume(const Vec3& edges, double range, const std::array<int, 3>& away) {
    // Along an axis, a distance x leaves edge - x for a pair within a tile, and x for one of neighbours.
    double sum = 0.0;
    double octants = 1.0;
    const double r3 = range * range * range;
    const std::array<double, 4> integral{std::numbers::pi * r3 / 6.0, std::numbers::pi * r3 * range / 16.0,
                                         r3 * range * range / 15.0, r3 * r3 / 48.0};
    for (unsigned axes = 0; axes < 8; ++axes) {  // those whose factor in the product is x rather than the edge
        double term = 1.0;
        std::size_t factors = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            const bool is_x = (axes >> a & 1U) != 0U;
            term *= away[a] == 0 ? (is_x ? -1.0 : edges[static_cast<Index>(a)]) : (is_x ? 1.0 : 0.0);
            factors += is_x ? 1 : 0;
        }
        sum += term * integral[factors];
    }
    for (const int along : away) {
        octants *= along == 0 ? 2.0 : 1.0;
    }
    return (away == std::array{0, 0, 0} ? 0.5 : 1.0) * octants * sum;
}

/// The tiles of a rank.
struct Tiles {
    Index inner = 0;           ///< without ghosts of other ranks: summed while messages are under way
    double own_pairs = 0.0;    ///< on their lists, both atoms here
    double ghost_pairs = 0.0;  ///< the second atom at another rank
};

/// @param tiles  number of tiles here
Tiles tiles_of(const ClusterGrid& grid, const Fluid& fluid, Index tiles) {
    const auto& along = grid.tiles_along();
    const Vec3 edges =
        cubic_box(fluid.atoms, fluid.density).edges().array() / Eigen::Array3d(along[0], along[1], along[2]);
    std::map<std::array<int, 3>, Index> here;
    for (Index tile = grid.first_tile(); tile < grid.first_tile() + tiles; ++tile) {
        here.emplace(grid.tile_places()[static_cast<std::size_t>(tile)], tile);
    }
    Tiles found;
    std::map<Index, bool> is_inner;
    for (int k = 13; k < 27; ++k) {  // the tile itself, and those towards higher z, y or x, which it has as ghosts
        const std::array<int, 3> away{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        const double each = fluid.density * fluid.density * pair_volume(edges, fluid.cutoff + fluid.skin, away);
        for (const auto& [place, tile] : here) {
            std::array<int, 3> other{};
            for (std::size_t a = 0; a < 3; ++a) {
                other[a] = (place[a] + away[a] + along[a]) % along[a];
            }
            const bool own = here.contains(other);
            (own ? found.own_pairs : found.ghost_pairs) += each;
            is_inner.try_emplace(tile, true).first->second &= own;
        }
    }
    found.inner = std::ranges::count(is_inner, true, &std::pair<const Index, bool>::second);
    return found;
}

ClusterGrid grid_of(const Fluid& fluid, int rank, int ranks) {
    ClusterGrid grid;
    grid.configure(cubic_box(fluid.atoms, fluid.density), fluid.cutoff + fluid.skin, fluid.atoms, std::nullopt,
                   fluid.cutoff + 2.0 * fluid.skin, LoneRank(rank, ranks));
    return grid;
}

/// What one rank has, as JSON.
std::string rank_as_json(const Fluid& fluid, int rank, int ranks, bool messages) {
    const ClusterGrid grid = grid_of(fluid, rank, ranks);
    struct Exchanged {
        double positions = 0.0;
        double forces = 0.0;
    };
    std::map<int, Exchanged> others;
    double ghosts = 0.0;
    double forces = 0.0;
    const auto returned = grid.force_parts();
    for (const ClusterGrid::HaloPart& part : grid.halo_parts()) {
        ghosts += others[part.rank].positions = atoms_in(part, fluid.density);
    }
    for (const ClusterGrid::HaloPart& part : returned) {
        forces += others[part.rank].forces = atoms_in(part, fluid.density);
    }
    const Index count = even_share(grid.tiles_of_all(), rank, ranks).count();
    const Tiles tiles = tiles_of(grid, fluid, count);
    std::string parts;
    if (messages) {
        std::vector<std::string> each;
        for (const auto& [other, exchanged] : others) {
            each.push_back(fmt::format("[{}, {:.1f}, {:.1f}]", other, exchanged.positions, exchanged.forces));
        }
        parts = fmt::format(R"(, "parts": [{}])", fmt::join(each, ", "));
    }
    return fmt::format(
        R"({{"rank": {}, "atoms": {:.1f}, "ghosts": {:.1f}, "messages": {}, "forces": {:.1f}, "force_messages": {}, )"
        R"("inner": {:.1f}, "own_pairs": {:.0f}, "ghost_pairs": {:.0f}{}}})",
        rank, fluid.density * grid.own_volume(), ghosts, others.size(), forces, returned.size(),
        fluid.density * grid.own_volume() * static_cast<double>(tiles.inner) / static_cast<double>(count),
        tiles.own_pairs, tiles.ghost_pairs, parts);
}

std::string decomposition_as_json(const Fluid& fluid, int ranks, bool messages) {
    constexpr std::size_t max_asked = 24;
    const Index tiles = grid_of(fluid, 0, 1).tiles_of_all();
    const Index most = (tiles + ranks - 1) / ranks;
    std::vector<int> candidates;
    for (int rank = 0; rank < ranks; ++rank) {
        if (messages || even_share(tiles, rank, ranks).count() == most) {
            candidates.push_back(rank);
        }
    }
    const std::size_t count = messages ? candidates.size() : std::min(candidates.size(), max_asked);
    std::vector<std::string> asked;
    for (std::size_t k = 0; k < count; ++k) {
        asked.push_back(rank_as_json(fluid, candidates[candidates.size() * k / count], ranks, messages));
    }
    return fmt::format(R"({{"atoms": {}, "ranks": {}, "asked": [{}], "tiles": {}}})", fluid.atoms, ranks,
                       fmt::join(asked, ", "), tiles);
}

}  // namespace

int main(int count, char** words) {
    const bool messages = count > 1 && std::string_view(words[1]) == "--messages";
    const int first = messages ? 2 : 1;
    if (count < first + 5) {
        std::fputs("usage: decomposition [--messages] ATOMS DENSITY CUTOFF SKIN RANKS...\n", stderr);
        return 2;
    }
    try {
        const Fluid fluid{std::stoll(words[first]), std::stod(words[first + 1]), std::stod(words[first + 2]),
                          std::stod(words[first + 3])};
        for (int k = first + 4; k < count; ++k) {
            fmt::print("{}\n", decomposition_as_json(fluid, std::stoi(words[k]), messages));
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return 1;
    }
    return 0;
}
