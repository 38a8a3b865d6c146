#include "report/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/fluid.hpp"
#include "report/lenient_data.hpp"

namespace ljmd {

namespace {

std::string number(double value) {
    return fmt::format("{:.6g}", value);
}

std::string stages_in_words(const Deck& deck) {
    std::string words;
    for (const Stage& stage : deck.stages()) {
        words += fmt::format(" Stage '{}': {}{} steps of {} with {}", stage.name,
                             stage.until.empty() ? "" : "until errors were reached, at most ", stage.steps,
                             number(stage.time_step), stage.integrator.name);
        if (stage.thermostat) {
            words +=
                fmt::format(", thermostat {} at temperature {}", stage.thermostat->name, number(*stage.temperature));
        }
        if (stage.barostat) {
            words += fmt::format(", barostat {}", stage.barostat->name);
        }
        words += stage.sample ? ", sampled." : ".";
    }
    return words;
}

std::string fluid_in_words(const RunFacts& facts, const Deck& deck) {
    const FluidSpec spec = fluid_spec(deck);
    std::string words = "A periodic box";
    if (const auto atoms = number_in(facts.results, {"system", "atoms"})) {
        words += fmt::format(" of {:.0f} atoms", *atoms);
    }
    if (const auto density = number_in(facts.results, {"system", "density"})) {
        words += fmt::format(" at density {} sigma^-3", number(*density));
    }
    words += fmt::format(" was simulated; all numbers are in reduced units. The potential was {}, {} at {} sigma{}.",
                         spec.potential.formula(), spec.potential.truncation(), number(spec.potential.cutoff().radius),
                         spec.has_tail() ? ", with corrections for the tail (g = 1 beyond the cutoff)" : "");
    return words + stages_in_words(deck) +
           " Standard errors are from block averages (Flyvbjerg and Petersen 1989, doi:10.1063/1.457480; length of the "
           "blocks after Lee et al. 2011, doi:10.1103/PhysRevE.83.066706).";
}

std::string bodies_in_words(const Deck& deck) {
    const FewBodySpec& spec = deck.few_bodies();
    return fmt::format("The motion of {} {} under the force {} was integrated, in the units of the deck.{}",
                       spec.bodies.size(), spec.bodies.size() == 1 ? "body" : "bodies", spec.force.name,
                       stages_in_words(deck));
}

}  // namespace

std::string methods_paragraph(const RunFacts& facts) {
    std::string words;
    if (const Deck* deck = facts.deck()) {
        words = (deck->is_fluid() ? fluid_in_words(facts, *deck) : bodies_in_words(*deck)) + " ";
    }
    return fmt::format("{}Computed with ljmd {} (commit {}; {} precision).", words, text_in(facts.record, {"version"}),
                       text_in(facts.record, {"commit"}).substr(0, 12), text_in(facts.record, {"precision"}));
}

std::string bibtex_of(const std::string& version) {
    return fmt::format(
        "@software{{ljmd,\n  author  = {{{{The ljmd developers}}}},\n  title   = {{ljmd: Lennard-Jones molecular "
        "dynamics}},\n  version = {{{}}},\n  license = {{GPL-3.0-or-later}}\n}}\n\n@article{{verlet1967,\n  author  = "
        "{{Loup Verlet}},\n  title   = {{Computer \"Experiments\" on Classical Fluids. {{I}}. Thermodynamical "
        "Properties "
        "of {{Lennard-Jones}} Molecules}},\n  journal = {{Physical Review}},\n  volume  = {{159}},\n  pages   = "
        "{{98--103}},\n  year    = {{1967}},\n  doi     = {{10.1103/PhysRev.159.98}}\n}}\n",
        version);
}

}  // namespace ljmd
