#include "ljmd/run/spec_deck.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "run/spec_plan.hpp"

namespace ljmd {

std::string deck_text(const FluidSpec& spec, const RunFiles& files, Precision precision,
                      const std::filesystem::path& start) {
    if (spec.potential.is_custom()) {
        throw InputError(fmt::format("potential: '{}' is a formula of the program, which no deck can name",
                                     spec.potential.formula()));
    }
    if (spec.external) {
        throw InputError(
            fmt::format("external: '{}' is a force of the program, which no deck can name", spec.external->name()));
    }
    return plan_of(spec, files, precision, start).source;
}

}  // namespace ljmd
