#include "io/formats/lammps_dump_writer.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <vector>

#include "io/formats/row_writer.hpp"
#include "ljmd/core/errors.hpp"
#include "model/atoms_by_id.hpp"

namespace ljmd {

void write_lammps_dump_frame(OutputFile& file, const State& state, const FrameContents& contents) {
    if (contents.source && !contents.source->step) {
        throw ContractViolation("every frame of a LAMMPS dump has a step");
    }
    const Vec3 edges = state.box().edges();
    const bool has_images = !contents.source || contents.source->is_unwrapped;
    file.write(
        fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n0 {}\n0 {}\n0 {}\n"
                    "ITEM: ATOMS id type x y z{}{}{}{}\n",
                    contents.source ? *contents.source->step : state.step, state.total(), edges[0], edges[1], edges[2],
                    has_images ? " ix iy iz" : "", contents.velocities ? " vx vy vz" : "",
                    contents.forces ? " fx fy fz" : "", contents.energies.empty() ? "" : " c_pe"));
    const AtomParts parts{.positions = true, .velocities = contents.velocities, .forces = contents.forces};
    visit_by_id(state, parts, [&](const AtomPiece& piece) {
        const std::vector<Vec3> places = has_images ? piece.positions : piece.unwrapped(state);
        write_rows(file, state.execution(), places.size(), [&](std::size_t k, fmt::memory_buffer& text) {
            const auto id = static_cast<std::size_t>(piece.first) + k;
            const auto to = fmt::appender(text);
            fmt::format_to(to, FMT_COMPILE("{} 1"), id_of(contents, id));
            append_vector(places[k], text);
            if (has_images) {
                const Eigen::Vector3i& image = piece.images[k];
                fmt::format_to(to, FMT_COMPILE(" {} {} {}"), image[0], image[1], image[2]);
            }
            if (contents.velocities) {
                append_vector(piece.velocities[k], text);
            }
            if (contents.forces) {
                append_vector(piece.forces[k], text);
            }
            if (!contents.energies.empty()) {
                fmt::format_to(to, FMT_COMPILE(" {}"), contents.energies[id]);
            }
            text.push_back('\n');
        });
    });
}

}  // namespace ljmd
