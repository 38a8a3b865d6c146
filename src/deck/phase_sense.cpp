#include "deck/phase_sense.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/fluid.hpp"
#include "ljmd/detail/engine/requested_temperature.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/reference/freezing.hpp"

namespace ljmd {

void check_phase(const Deck& deck, double density, Diagnostics& diagnostics) {
    const bool box_changes = std::ranges::any_of(
        deck.stages(), [](const Stage& stage) { return stage.steps > 0 && stage.barostat.has_value(); });
    if (box_changes || deck.given.potential || deck.potential().type != LennardJones::name) {
        return;
    }
    const FluidSpec spec = fluid_spec(deck);
    const auto temperature = requested_temperature(spec);
    if (!temperature) {
        return;
    }
    const auto densities = freezing_densities(*temperature);
    if (!densities || density <= densities->freezing) {
        return;
    }
    const bool of_crystal = std::ranges::any_of(
        spec.analyses, [](const Choice& analysis) { return find_analysis(analysis.name).of_crystal; });
    if (of_crystal && density >= densities->melting) {
        return;  // the deck wants the crystal, which is stable
    }
    const Placed<SystemTable>& system = deck.system();
    diagnostics.warning(
        system.density ? system.location(&SystemTable::density) : system.location(&SystemTable::file),
        fmt::format(
            "the density is {:.6g}: at temperature {:.6g} the fluid of the full Lennard-Jones potential freezes "
            "at {:.4f}, and its crystal melts at {:.4f} (Mastny and de Pablo 2007)",
            density, *temperature, densities->freezing, densities->melting),
        density < densities->melting ? "fluid and crystal coexist here; a fluid alone is metastable"
                                     : "the crystal is stable here, and a fluid metastable");
}

}  // namespace ljmd
