#include <fmt/format.h>

#include <cmath>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/reference/equation_doubts.hpp"
#include "ljmd/reference/equation_report.hpp"

namespace ljmd {

namespace {

void require_number(const char* option, double value, bool or_zero) {
    if (!std::isfinite(value) || value < 0.0 || (value == 0.0 && !or_zero)) {
        throw InputError(
            fmt::format("{}: {} is not allowed: a finite number {} 0", option, value, or_zero ? ">=" : ">"));
    }
}

}  // namespace

void eos_command(const EosOptions& options) {
    const EquationOfState equation = equation_of_state(options.model.empty() ? "thol2016" : options.model);
    if (!options.temperature) {
        if (!options.model.empty()) {
            throw InputError("--model wants a --temperature; without one all equations are listed");
        }
        if (options.density) {
            throw InputError("--density wants a --temperature");
        }
        print_document(equations_document(), options.json);
        return;
    }
    require_number("--temperature", *options.temperature, false);
    if (!options.density) {
        const Document found = coexistence_document(equation, *options.temperature);
        const FluidProperties liquid = coexistence(equation, *options.temperature)->liquid;
        if (const std::string outside = outside_of_range(equation, liquid); !outside.empty()) {
            warn(outside);
        }
        print_document(found, options.json);
        return;
    }
    require_number("--density", *options.density, true);
    const Document found = state_document(equation, *options.temperature, *options.density);
    for (const std::string& doubt : doubts(equation, *options.temperature, *options.density)) {
        warn(doubt);
    }
    print_document(found, options.json);
}

}  // namespace ljmd
