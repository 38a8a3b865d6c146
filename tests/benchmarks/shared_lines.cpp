// Counts the cache lines that pass from core to core in a step without a new list, by the thread that wrote each line
// last. Nothing is timed.
//
//     shared_lines [THREADS [CELLS...]]      by default 2 threads, and crystals of 4 CELLS^3 atoms with CELLS 6, 10,
//     20, 40
//
// A line (64 bytes) counts each time that a thread reads or writes it and another one wrote it last:
//
//     positions       own atoms and ghosts of a tile, read by its thread; the thread that moves the atoms wrote them
//     forces          of a tile's own atoms, written by its thread, read by the one that moves the atoms
//     ghost forces    written by the thread of the tile that found them, read by that of the tile that owns the atoms
//
// "blocks of 128": atoms are moved in blocks of 128, and threads have equally many blocks and tiles.
// "equal shares": as the program does it, see for_each_range() and VerletList::work_before().

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "execution/loops.hpp"
#include "ljmd/model/lattice.hpp"
#include "neighbors/verlet_list.hpp"

namespace {

using namespace ljmd;

constexpr Index line_bytes = 64;
constexpr Index atom_bytes = vector_stride * Index{sizeof(double)};

/// The thread of each index, as a new team shares a loop out. The caller waits until all others have begun, and then
/// takes its time, so that it helps nobody.
std::vector<int> owners(int threads, Index count, Index blocks,
                        const std::function<void(const Execution&, BlockFunction)>& loop) {
    std::vector<int> owner(static_cast<std::size_t>(count));
    std::vector<std::atomic<bool>> begun(static_cast<std::size_t>(threads));
    const auto workers = static_cast<std::ptrdiff_t>(std::min<Index>(threads, blocks)) - 1;
    loop(Execution({.threads = threads}), [&](Index first, Index last) {
        begun[static_cast<std::size_t>(number_in_team())] = true;
        std::fill(owner.begin() + first, owner.begin() + last, number_in_team());
        if (number_in_team() == 0) {
            do {
                std::this_thread::sleep_for(std::chrono::microseconds(300));
            } while (std::count(begun.begin() + 1, begun.end(), true) < workers);
        }
    });
    return owner;
}

struct Lines {
    Index positions = 0;
    Index forces = 0;
    Index ghost_forces = 0;
};

/// @param movers  thread that moves each atom  @param summers  thread of each tile
Lines count(const VerletList& list, const std::vector<int>& movers, const std::vector<int>& summers) {
    Lines lines;
    const auto mover_of_line = [&](Index line) {
        return movers[static_cast<std::size_t>(line * line_bytes / atom_bytes)];
    };
    std::set<std::pair<int, Index>> read;  // by a thread in this step: its cache has the line then
    const auto look = [&](int thread, const AtomRange& atoms) {
        for (Index line = atoms.first * atom_bytes / line_bytes; line * line_bytes < atoms.last * atom_bytes; ++line) {
            if (mover_of_line(line) != thread && read.insert({thread, line}).second) {
                ++lines.positions;
            }
        }
    };
    const ClusterGrid& grid = list.clusters();
    for (std::size_t t = 0; t < summers.size(); ++t) {
        const AtomRange own = grid.atoms_of_tile(static_cast<Index>(t));
        look(summers[t], own);
        for (const ClusterGrid::GhostClusters& ghosts : list.tiles()[t].ghosts) {
            look(summers[t], grid.atoms_of(ghosts.of));
        }
        for (Index line = own.first * atom_bytes / line_bytes; line * line_bytes < own.last * atom_bytes; ++line) {
            lines.forces += mover_of_line(line) != summers[t] ? 2 : 0;  // there, and back in the next step
        }
        for (const GhostRoutes::Export& one : list.routes().of_tile(static_cast<Index>(t))) {
            if (summers[static_cast<std::size_t>(one.tile)] != summers[t]) {
                lines.ghost_forces += (Index{3} * one.count * Index{sizeof(double)} + line_bytes - 1) / line_bytes;
            }
        }
    }
    return lines;
}

void print(int cells, const char* rule, const Lines& lines) {
    const Index all = lines.positions + lines.forces + lines.ghost_forces;
    fmt::print("{:>8} {:>14} {:>10} {:>8} {:>13} {:>8} {:>14.3f}\n", 4 * cells * cells * cells, rule, lines.positions,
               lines.forces, lines.ghost_forces, all, static_cast<double>(all) / (4.0 * cells * cells * cells));
}

}  // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
    std::vector<int> sizes;
    for (int k = 2; k < argc; ++k) {
        sizes.push_back(std::atoi(argv[k]));
    }
    if (sizes.empty()) {
        sizes = {6, 10, 20, 40};
    }
    if (threads < 2 || std::ranges::any_of(sizes, [](int cells) { return cells < 4; })) {
        std::fputs("usage: shared_lines [THREADS [CELLS...]], threads from 2 on, cells from 4 on\n", stderr);
        return 2;
    }
    fmt::print("{} threads\n{:>8} {:>14} {:>10} {:>8} {:>13} {:>8} {:>14}\n", threads, "atoms", "rule", "positions",
               "forces", "ghost forces", "lines", "lines an atom");
    for (const int cells : sizes) {
        const Index atoms = lattice_atoms(Lattice::fcc, cells);
        const Box box = cubic_box(atoms, 0.8442);
        State state(atoms, box, Execution({.threads = threads}));
        const std::vector<Vec3> sites = lattice_sites(Lattice::fcc, cells, box);
        auto r = state.write_positions();
        for (Index i = 0; i < atoms; ++i) {
            r.col(i) = state.snapped(sites[static_cast<std::size_t>(i)]);
        }
        VerletList list(0.3);
        list.prepare(state, 2.5);
        const auto tiles = static_cast<Index>(list.tiles().size());
        const auto before = [&](Index count, Index length) {
            return owners(threads, count, (count + length - 1) / length,
                          [&](const Execution& execution, BlockFunction function) {
                              for_each_block(execution, count, length, function);
                          });
        };
        print(cells, "blocks of 128", count(list, before(atoms, 128), before(tiles, 1)));
        const auto movers = owners(
            threads, atoms, std::max<Index>(1, atoms / loop_block),
            [&](const Execution& execution, BlockFunction function) { for_each_range(execution, atoms, function); });
        const auto summers = owners(threads, tiles, tiles, [&](const Execution& execution, BlockFunction function) {
            for_each_block(execution, tiles, 1, function, list.work_before());
        });
        print(cells, "equal shares", count(list, movers, summers));
    }
    return 0;
}
