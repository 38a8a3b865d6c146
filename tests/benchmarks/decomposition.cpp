// How a fluid of even density is shared among ranks: for each number of ranks one line of JSON, with the tiles, atoms,
// ghosts and messages of some of them.
//
//     decomposition ATOMS DENSITY CUTOFF SKIN RANKS...
//
// No atom is made: the program asks the grid of the neighbour list (ClusterGrid), as it does in a run, which tiles a
// rank has and what it takes of others. Of more than 24 ranks 24 are asked, evenly spaced.

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "ljmd/model/lattice.hpp"
#include "ljmd/neighbors/cluster_grid.hpp"

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

std::string described(Index atoms, double density, double cutoff, double skin, int ranks) {
    constexpr int max_asked = 24;
    const Box box = cubic_box(atoms, density);
    std::string asked;
    for (int k = 0; k < std::min(ranks, max_asked); ++k) {
        const int rank = static_cast<int>(even_share(ranks, k, std::min(ranks, max_asked)).first);
        ClusterGrid grid;
        grid.configure(box, cutoff + skin, atoms, std::nullopt, cutoff + 2.0 * skin, LoneRank(rank, ranks));
        double ghosts = 0.0;
        const auto parts = grid.halo_parts();
        for (const ClusterGrid::HaloPart& part : parts) {
            ghosts += density * part.volume;
        }
        asked += fmt::format(R"({}{{"rank": {}, "atoms": {:.1f}, "ghosts": {:.1f}, "messages": {}}})",
                             k == 0 ? "" : ", ", rank, density * grid.own_volume(), ghosts, parts.size());
        if (k + 1 == std::min(ranks, max_asked)) {
            asked += fmt::format(R"(], "tiles": {})", grid.tiles_of_all());
        }
    }
    return fmt::format(R"({{"atoms": {}, "ranks": {}, "asked": [{}}})", atoms, ranks, asked);
}

}  // namespace

int main(int count, char** words) {
    if (count < 6) {
        std::fputs("usage: decomposition ATOMS DENSITY CUTOFF SKIN RANKS...\n", stderr);
        return 2;
    }
    try {
        for (int k = 5; k < count; ++k) {
            fmt::print("{}\n", described(std::stoll(words[1]), std::stod(words[2]), std::stod(words[3]),
                                         std::stod(words[4]), std::stoi(words[k])));
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return 1;
    }
    return 0;
}
