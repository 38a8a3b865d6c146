#include "ljmd/io/formats/lammps_dump_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <vector>

namespace ljmd {

namespace {

void append_numbers(std::string& line, const Vec3& v) {
    fmt::format_to(std::back_inserter(line), " {} {} {}", v[0], v[1], v[2]);
}

}  // namespace

void write_lammps_dump_frame(OutputFile& file, const State& state, const FrameContents& contents) {
    const Vec3 edges = state.box().edges();
    file.write(
        fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n0 {}\n0 {}\n0 {}\n"
                    "ITEM: ATOMS id type x y z ix iy iz{}{}{}\n",
                    state.step, state.count(), edges[0], edges[1], edges[2], contents.velocities ? " vx vy vz" : "",
                    contents.forces ? " fx fy fz" : "", contents.energies.empty() ? "" : " c_pe"));
    const std::vector<Index> index_of = state.index_of();
    std::string line;
    for (std::size_t id = 0; id < index_of.size(); ++id) {
        const Index i = index_of[id];
        const Eigen::Vector3i& image = state.image(i);
        line = fmt::format("{} 1", id + 1);
        append_numbers(line, state.positions().col(i));
        fmt::format_to(std::back_inserter(line), " {} {} {}", image[0], image[1], image[2]);
        if (contents.velocities) {
            append_numbers(line, state.velocities().col(i));
        }
        if (contents.forces) {
            append_numbers(line, state.forces().col(i));
        }
        if (!contents.energies.empty()) {
            fmt::format_to(std::back_inserter(line), " {}", contents.energies[id]);
        }
        file.write(line += '\n');
    }
}

}  // namespace ljmd
