#include "ljmd/io/formats/lammps_dump_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "ljmd/model/atoms_by_id.hpp"

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
                    state.step, state.total(), edges[0], edges[1], edges[2], contents.velocities ? " vx vy vz" : "",
                    contents.forces ? " fx fy fz" : "", contents.energies.empty() ? "" : " c_pe"));
    std::string line;
    const AtomParts parts{.positions = true, .velocities = contents.velocities, .forces = contents.forces};
    visit_by_id(state, parts, [&](const AtomPiece& piece) {
        for (std::size_t k = 0; k < piece.positions.size(); ++k) {
            const auto id = static_cast<std::size_t>(piece.first) + k;
            line = fmt::format("{} 1", id + 1);
            append_numbers(line, piece.positions[k]);
            const Eigen::Vector3i& image = piece.images[k];
            fmt::format_to(std::back_inserter(line), " {} {} {}", image[0], image[1], image[2]);
            if (contents.velocities) {
                append_numbers(line, piece.velocities[k]);
            }
            if (contents.forces) {
                append_numbers(line, piece.forces[k]);
            }
            if (!contents.energies.empty()) {
                fmt::format_to(std::back_inserter(line), " {}", contents.energies[id]);
            }
            file.write(line += '\n');
        }
    });
}

}  // namespace ljmd
