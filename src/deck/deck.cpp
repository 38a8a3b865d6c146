#include "deck/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "deck/deck_sense.hpp"
#include "deck/deck_stages.hpp"
#include "deck/effect_sense.hpp"
#include "deck/few_body_sense.hpp"
#include "deck/phase_sense.hpp"
#include "deck/start_sense.hpp"
#include "input/deck_file.hpp"
#include "input/deck_setting.hpp"

namespace ljmd {

namespace {

/// Whether all units derived from these three are normal numbers, so that one can divide by them.
bool make_units(double sigma, double epsilon, double mass) {
    const SubstanceUnits units(sigma, epsilon, mass);
    const auto usable = [&](Dimension dimension) { return std::isnormal(units.si(dimension)); };
    return usable(Dimension::time) && usable(Dimension::density) && usable(Dimension::pressure) &&
           usable(Dimension::velocity) && usable(Dimension::temperature);
}

/// [argon] is read first, because other values may use its units. Its own mistakes are reported when the whole deck is
/// validated.
std::optional<SubstanceUnits> substance_units(const Table& table, Diagnostics& diagnostics) {
    const Entry* entry = find(table, Placed<FluidTables>::key(&FluidTables::argon));
    if (entry == nullptr || !std::holds_alternative<Table>(entry->value.data)) {
        return std::nullopt;
    }
    Diagnostics ignored;
    const Placed<ArgonTable> argon(validate(std::get<Table>(entry->value.data), entry->key_location,
                                            Placed<ArgonTable>::schema("[argon]"), std::nullopt, ignored));
    // Of argon, so that other quantities can be checked as if it were there; the deck is refused anyway.
    const SubstanceUnits stand_in(parse_quantity("3.405 angstrom", Dimension::length).value(),
                                  parse_quantity("119.8 K", Dimension::energy).value(),
                                  parse_quantity("39.948 u", Dimension::mass).value());
    if (ignored.has_errors()) {
        return stand_in;
    }
    if (!make_units(argon.sigma, argon.epsilon, argon.mass)) {
        diagnostics.error(entry->key_location, "the values in [argon] make units beyond the range of double precision");
        return stand_in;
    }
    return SubstanceUnits(argon.sigma, argon.epsilon, argon.mass);
}

/// The tables of a deck determine its kind.
DeckKind kind_of(const Table& table) {
    const auto is_there = [&table](const std::string& name) { return find(table, name) != nullptr; };
    return std::ranges::any_of(marks_of_few_bodies(), is_there) ? DeckKind::few_body : DeckKind::fluid;
}

/// Explain why a deck that mixes both kinds has many unknown tables.
void explain_mixture(const Table& table, Diagnostics& diagnostics) {
    const auto key = [](auto member) { return Placed<FluidTables>::key(member); };
    for (const std::string& name : {key(&FluidTables::system), key(&FluidTables::potential),
                                    key(&FluidTables::neighbors), key(&FluidTables::argon)}) {
        if (const Entry* entry = find(table, name)) {
            diagnostics.error(
                entry->key_location,
                fmt::format("[{}] belongs to a fluid, but this deck has [force] or [[body]]", name),
                "a few-body deck has no box and no temperature, and its numbers are in whatever units go together");
        }
    }
}

/// Explain why few bodies do not run until an error is reached.
void refuse_until(const Table& table, Diagnostics& diagnostics) {
    const Entry* stages = find(table, Placed<FewBodyTables>::key(&FewBodyTables::stages));
    const auto* array = stages != nullptr ? std::get_if<Array>(&stages->value.data) : nullptr;
    for (const Value& stage : array != nullptr ? *array : Array()) {
        const auto* keys = std::get_if<Table>(&stage.data);
        const Entry* until = keys != nullptr ? find(*keys, Placed<Stage>::key(&Stage::until)) : nullptr;
        if (until != nullptr) {
            diagnostics.error(until->key_location,
                              "'until' in [[stage]] is for fluids: a motion of few bodies has no averages with errors",
                              "give a number of steps");
        }
    }
}

std::filesystem::path default_directory(const std::filesystem::path& deck) {
    return std::filesystem::path("runs") / deck.stem();
}

FewBodySpec spec_of(const FewBodyTables& tables) {
    return {.force = tables.force.method,
            .bodies = {tables.bodies.begin(), tables.bodies.end()},
            .stages = stages_of(tables),
            .sample_every = tables.output.thermo.every,
            .analyses = tables.analysis.asked};
}

template <class Tables>
Deck to_deck(const std::filesystem::path& path, const DeckFile& file, const std::vector<std::string>& settings,
             const Placed<Tables>& tables, decltype(RunPlan::spec) spec) {
    const auto& output = tables.output;
    Deck deck{{{.title = tables.title,
                .trajectory = output.trajectory ? std::optional<TrajectoryOutput>(*output.trajectory) : std::nullopt,
                .checkpoint = output.checkpoint},
               path.string(),
               file.source->text,
               settings,
               std::move(spec)},
              tables};
    deck.directory = output.directory ? std::filesystem::path(*output.directory) : default_directory(path);
    deck.report = output.report;
    return deck;
}

/// A potential of the program, and what the deck says that does not go with it.
void check_given_potential(const GivenParts& given, const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    if (!given.potential || diagnostics.has_errors()) {
        return;
    }
    const Placed<PotentialTable>& potential = tables.potential;
    if (potential.radius != given.potential->cutoff.radius || potential.truncation != given.potential->truncation ||
        (potential.given(&PotentialTable::switch_start) &&
         potential.switch_start != given.potential->cutoff.switch_start)) {
        diagnostics.error(
            potential.location(&PotentialTable::radius),
            fmt::format("the pair potential of the program has truncation '{}' at {}, and these cannot be "
                        "changed",
                        given.potential->truncation, given.potential->cutoff.radius));
    }
    const Placed<PerformanceTable>& performance = tables.performance;
    if (precision_of(performance.precision) == Precision::mixed) {
        diagnostics.error(performance.location(&PerformanceTable::precision),
                          "a pair potential of the program is computed in double precision");
    }
}

/// @param path  the deck's name in messages
std::optional<Deck> deck_of(const std::filesystem::path& path, DeckFile file, const std::vector<std::string>& settings,
                            bool force, Diagnostics& diagnostics, GivenParts given = {}) {
    if (diagnostics.has_errors()) {
        return std::nullopt;
    }
    for (const std::string& setting : settings) {
        apply_setting(file.table, setting, diagnostics);
    }
    const Location whole{file.source, 0, 0, 1};
    const DeckKind kind = kind_of(file.table);
    if (kind == DeckKind::few_body) {
        explain_mixture(file.table, diagnostics);
        refuse_until(file.table, diagnostics);
        if (!given.empty()) {
            diagnostics.error(whole,
                              "a pair potential and observers of a program are for fluids: this deck has few bodies");
        }
        if (diagnostics.has_errors()) {
            return std::nullopt;
        }
    }
    const auto units = kind == DeckKind::fluid ? substance_units(file.table, diagnostics) : std::nullopt;
    const Section root = validate(file.table, whole, deck_schema(kind), units, diagnostics);
    // Check sense even if single values are wrong, as far as possible.
    if (kind == DeckKind::few_body) {
        const Placed<FewBodyTables> tables(root);
        check_few_body_sense(tables, diagnostics);
        if (diagnostics.has_errors()) {
            return std::nullopt;
        }
        check_few_body_effects(tables, diagnostics);
        return to_deck(path, file, settings, tables, spec_of(tables));
    }
    const Placed<FluidTables> tables(root);
    check_sense(tables, units.has_value(), force, diagnostics);
    check_given_potential(given, tables, diagnostics);
    if (diagnostics.has_errors()) {
        return std::nullopt;
    }
    check_effects(tables, diagnostics);
    Deck deck = to_deck(path, file, settings, tables, spec_of(tables, units));
    deck.precision = precision_of(tables.performance.precision);
    deck.given = std::move(given);
    if (tables.system.file) {
        deck.start_file = configuration_file(*tables.system.file);
    }
    if (tables.system.lattice) {  // a file is checked later, see check_start
        check_start_effects(tables, false, diagnostics);
        if (!tables.system.lattice->height) {
            check_phase(deck, *tables.system.density, diagnostics);
        }
    }
    return deck;
}

}  // namespace

std::optional<Deck> load_deck(const std::filesystem::path& path, const std::vector<std::string>& settings, bool force,
                              Diagnostics& diagnostics) {
    return deck_of(path, read_deck(path, diagnostics), settings, force, diagnostics);
}

std::optional<Deck> load_deck_text(const std::string& name, const std::string& text,
                                   const std::vector<std::string>& settings, bool force, Diagnostics& diagnostics,
                                   GivenParts given) {
    return deck_of(name, parse_deck(name, text, diagnostics), settings, force, diagnostics, std::move(given));
}

}  // namespace ljmd
