#include "io/formats/extended_xyz_writer.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "io/files/replacement_file.hpp"
#include "io/formats/ase_units.hpp"
#include "io/formats/row_writer.hpp"
#include "io/formats/unit_scale.hpp"
#include "model/atoms_by_id.hpp"

namespace ljmd {

namespace {

constexpr double angstrom_per_nanometre = 10.0;

/// epsilon in the unit of energy of the file.
double energy_scale(const std::optional<SubstanceUnits>& si) {
    return si ? si->si(Dimension::energy) / ase_energy : 1.0;
}

bool has_ids(const FrameContents& contents) {
    return !contents.source || !contents.source->ids.empty();
}

std::string header(const State& state, const FrameContents& contents, bool si, const UnitScale& scale) {
    std::string text = fmt::format("{}\n", state.total());
    if (state.has_box()) {
        const Vec3 edges = scale.length * state.box().edges();
        text += fmt::format("Lattice=\"{} 0 0 0 {} 0 0 0 {}\" ", edges[0], edges[1], edges[2]);
    }
    text += fmt::format("Properties=species:S:1:pos:R:3{}{}{}{} pbc=\"{}\"",
                        contents.velocities ? ":velo:R:3:momenta:R:3" : "", contents.forces ? ":forces:R:3" : "",
                        contents.energies.empty() ? "" : ":energies:R:1", has_ids(contents) ? ":id:I:1" : "",
                        state.has_box() ? "T T T" : "F F F");
    const FrameFacts facts = contents.source.value_or(FrameFacts{state.step, state.time, true, {}});
    if (facts.time) {
        text += fmt::format(" Time={}", scale.time * *facts.time);
    }
    if (facts.step) {
        text += fmt::format(" step={}", *facts.step);
    }
    text += fmt::format(" units={}{}\n", si ? "si" : "reduced", facts.is_unwrapped ? " positions=unwrapped" : "");
    return text;
}

}  // namespace

void write_extended_xyz_frame(OutputFile& file, const State& state, const FrameContents& contents,
                              const std::optional<SubstanceUnits>& si) {
    const UnitScale scale = unit_scale(si, angstrom_per_nanometre);
    file.write(header(state, contents, si.has_value(), scale));
    const char* species = si ? "Ar" : "X";
    const double momentum = ase_mass(species).value() / (si ? ase_velocity : 1.0);
    const double energy = energy_scale(si);
    const bool ids = has_ids(contents);
    const AtomParts parts{.positions = true, .velocities = contents.velocities, .forces = contents.forces};
    visit_by_id(state, parts, [&](const AtomPiece& piece) {
        const std::vector<Vec3> places = piece.unwrapped(state);
        write_rows(file, state.execution(), places.size(), [&](std::size_t k, fmt::memory_buffer& text) {
            const auto id = static_cast<std::size_t>(piece.first) + k;
            const auto to = fmt::appender(text);
            fmt::format_to(to, FMT_COMPILE("{}"), species);
            append_vector(scale.length * places[k], text);
            if (contents.velocities) {
                const Vec3 v = scale.velocity * piece.velocities[k];
                const std::size_t begin = text.size();
                append_vector(v, text);
                const std::size_t end = text.size();
                const Vec3 p = momentum * v;
                if (p == v) {  // the same text; to format numbers takes most of the time
                    text.reserve(end + (end - begin));
                    text.append(text.data() + begin, text.data() + end);
                } else {
                    append_vector(p, text);
                }
            }
            if (contents.forces) {
                append_vector(energy / scale.length * piece.forces[k], text);
            }
            if (!contents.energies.empty()) {
                fmt::format_to(to, FMT_COMPILE(" {}"), energy * contents.energies[id]);
            }
            if (ids) {
                fmt::format_to(to, FMT_COMPILE(" {}"), id_of(contents, id));
            }
            text.push_back('\n');
        });
    });
}

void write_configuration(const OutputPlace& place, const State& state, bool velocities) {
    write_file_atomically(place, [&](OutputFile& file) {
        write_extended_xyz_frame(file, state, {.velocities = velocities}, std::nullopt);
    });
}

}  // namespace ljmd
