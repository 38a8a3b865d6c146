#include "ljmd/deck/deck.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/deck/deck_sense.hpp"
#include "ljmd/deck/deck_stages.hpp"
#include "ljmd/deck/effect_sense.hpp"
#include "ljmd/deck/few_body_sense.hpp"
#include "ljmd/deck/phase_sense.hpp"
#include "ljmd/deck/start_sense.hpp"
#include "ljmd/input/deck_file.hpp"
#include "ljmd/input/deck_setting.hpp"

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
    const Entry* argon = find(table, "argon");
    if (argon == nullptr || !std::holds_alternative<Table>(argon->value.data)) {
        return std::nullopt;
    }
    Diagnostics ignored;
    const Schema schema = deck_schema(DeckKind::fluid).find("argon")->inner.front();
    const Section section =
        validate(std::get<Table>(argon->value.data), argon->key_location, schema, std::nullopt, ignored);
    const SubstanceUnits stand_in(1.0, 1.0, 1.0);  // so that the other units can be checked; the deck is refused anyway
    if (ignored.has_errors()) {
        return stand_in;
    }
    const double sigma = section.number("sigma");
    const double epsilon = section.number("epsilon");
    const double mass = section.number("mass");
    if (!make_units(sigma, epsilon, mass)) {
        diagnostics.error(argon->key_location, "the values in [argon] make units beyond the range of double precision");
        return stand_in;
    }
    return SubstanceUnits(sigma, epsilon, mass);
}

/// Add missing tables that have only optional keys: they exist with their defaults.
void add_optional_tables(Table& table, DeckKind kind, const Location& where) {
    for (const char* name : {"neighbors", "performance", "output", "analysis"}) {
        if (deck_schema(kind).find(name) != nullptr && find(table, name) == nullptr) {
            table.push_back({name, where, Value{Table{}, where}});
        }
    }
}

/// The tables of a deck determine its kind.
DeckKind kind_of(const Table& table) {
    return find(table, "force") != nullptr || find(table, "body") != nullptr ? DeckKind::few_body : DeckKind::fluid;
}

/// Explain why a deck that mixes both kinds has many unknown tables.
void explain_mixture(const Table& table, Diagnostics& diagnostics) {
    for (const char* name : {"system", "potential", "neighbors", "argon"}) {
        if (const Entry* entry = find(table, name)) {
            diagnostics.error(
                entry->key_location,
                fmt::format("[{}] belongs to a fluid, but this deck has [force] or [[body]]", name),
                "a few-body deck has no box and no temperature, and its numbers are in whatever units go together");
        }
    }
}

std::filesystem::path default_directory(const std::filesystem::path& deck) {
    return std::filesystem::path("runs") / deck.stem();
}

CheckpointOutput checkpoint_output(const Section& output) {
    if (!output.has("checkpoint")) {
        constexpr double usual = 300.0;  // [s], as in the schema
        return {{std::nullopt, usual}, 2};
    }
    const Section& checkpoint = output.section("checkpoint");
    return {checkpoint.interval("every"), static_cast<int>(checkpoint.integer("keep"))};
}

Deck to_deck(DeckKind kind, const std::filesystem::path& path, const DeckFile& file,
             const std::vector<std::string>& settings, const std::optional<SubstanceUnits>& units,
             const Section& root) {
    Deck deck{kind,
              path.string(),
              file.source->text,
              settings,
              root.text("title"),
              units,
              root,
              stages_of(root),
              {},
              std::nullopt,
              0,
              std::nullopt,
              checkpoint_output(root.section("output"))};
    const Section& output = root.section("output");
    deck.directory =
        output.has("directory") ? std::filesystem::path(output.text("directory")) : default_directory(path);
    const Index usual = kind == DeckKind::few_body ? 1 : 10;
    deck.thermo_every = output.has("thermo") ? output.section("thermo").integer("every") : usual;
    if (output.has("trajectory")) {
        const Section& t = output.section("trajectory");
        deck.trajectory = {t.text("format"), t.integer("every"), t.flag("velocities"),
                           t.has("accelerations") && t.flag("accelerations"),
                           t.has("units") && t.text("units") == "si"};
    }
    return deck;
}

/// @param path  the deck's name in messages
std::optional<Deck> deck_of(const std::filesystem::path& path, DeckFile file, const std::vector<std::string>& settings,
                            bool force, Diagnostics& diagnostics) {
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
        if (diagnostics.has_errors()) {
            return std::nullopt;
        }
    }
    add_optional_tables(file.table, kind, whole);
    const auto units = kind == DeckKind::fluid ? substance_units(file.table, diagnostics) : std::nullopt;
    const Section root = validate(file.table, whole, deck_schema(kind), units, diagnostics);
    // Check sense even if single values are wrong, as far as possible.
    if (kind == DeckKind::few_body) {
        check_few_body_sense(root, diagnostics);
    } else if (root.has("system") && root.has("potential") && root.has("stage")) {
        check_sense(root, units.has_value(), force, diagnostics);
    }
    if (diagnostics.has_errors()) {
        return std::nullopt;
    }
    const Deck deck = to_deck(kind, path, file, settings, units, root);
    if (kind == DeckKind::few_body) {
        check_few_body_effects(root, diagnostics);
        return deck;
    }
    check_effects(root, diagnostics);
    if (const Section& system = deck.system(); system.has("lattice")) {  // a file is checked later, see check_start
        check_start_effects(root, false, diagnostics);
        check_phase(deck, system.number("density"), diagnostics);
    }
    return deck;
}

}  // namespace

std::optional<Deck> load_deck(const std::filesystem::path& path, const std::vector<std::string>& settings, bool force,
                              Diagnostics& diagnostics) {
    return deck_of(path, read_deck(path, diagnostics), settings, force, diagnostics);
}

std::optional<Deck> load_deck_text(const std::string& name, const std::string& text,
                                   const std::vector<std::string>& settings, bool force, Diagnostics& diagnostics) {
    return deck_of(name, parse_deck(name, text, diagnostics), settings, force, diagnostics);
}

}  // namespace ljmd
