#include "python/loaded_deck.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>
#include <variant>

#include "deck/checked_run.hpp"
#include "deck/deck_schema.hpp"
#include "deck/deck_system.hpp"
#include "input/deck_file.hpp"
#include "input/deck_setting.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/run/spec_deck.hpp"
#include "python/deck_values.hpp"
#include "python/pair.hpp"

namespace ljmd::python {

namespace {

using DeckSource = std::variant<std::string, py::dict>;  // the text of a deck, or its tables

std::string source_text(const DeckSource& source, const PairOfPython* pair) {
    if (const auto* text = std::get_if<std::string>(&source)) {
        return *text;
    }
    const std::string tables = deck_text(std::get<py::dict>(source));
    return pair == nullptr ? tables
                           : fmt::format(
                                 "# The pair potential is '{}', a function of Python: that in [potential] "
                                 "stands in for it.\n{}",
                                 pair->potential().formula(), tables);
}

/// The tables of a deck as dicts, unchecked.
py::dict parsed(const std::string& name, const DeckSource& source, const std::vector<std::string>& settings) {
    Diagnostics diagnostics;
    DeckFile file = parse_deck(name, source_text(source, nullptr), diagnostics);
    diagnostics.throw_if_errors();
    for (const std::string& setting : settings) {
        apply_setting(file.table, setting, diagnostics);
    }
    diagnostics.throw_if_errors();
    return to_python(file.table);
}

/// @param pair  the pair potential of the calling program, if it gives one
std::unique_ptr<LoadedDeck> loaded(const std::string& name, const DeckSource& source,
                                   const std::vector<std::string>& settings, bool force, const PairOfPython* pair) {
    Diagnostics diagnostics;
    GivenParts given{.by = "Python"};
    if (pair != nullptr) {
        given.potential = pair->given();
    }
    auto deck = load_deck_text(name, source_text(source, pair), settings, force, diagnostics, std::move(given));
    diagnostics.throw_if_errors();
    if (pair != nullptr && deck->potential().has_tail()) {
        throw InputError("a pair potential in Python is not known beyond its cutoff: it takes tail=False");
    }
    return std::make_unique<LoadedDeck>(LoadedDeck{std::move(*deck), std::move(diagnostics)});
}

/// The text of a file, as decks are read. @throws InputError
std::string text_of_file(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    const DeckFile file = read_deck(path, diagnostics);
    diagnostics.throw_if_errors();
    return file.source->text;
}

/// sigma [angstrom], epsilon [eV] and mass [u] of a deck's substance; None: it has none.
py::object substance_of(const LoadedDeck& loaded) {
    if (!loaded.deck.units()) {
        return py::none();
    }
    const SubstanceUnits& units = *loaded.deck.units();
    constexpr double angstrom_per_nanometre = 10.0;
    constexpr double electron_volt = 1.602176634e-19;  // [J], exact
    return py::make_tuple(angstrom_per_nanometre * units.nanometre(), units.si(Dimension::energy) / electron_volt,
                          units.dalton());
}

/// (data, text, warnings) of `ljmd check`.
py::tuple checked(const LoadedDeck& loaded, int threads, const std::string& simd) {
    Document report;
    Diagnostics diagnostics = loaded.diagnostics;
    {
        const WithoutLock free;
        report = check_report(loaded.deck, checked_run(loaded.deck, threads, simd, diagnostics));
    }
    return py::make_tuple(to_python(report.data), python_text(report.text), warnings_of(diagnostics));
}

}  // namespace

py::dict default_tables() {
    return parsed("", deck_text(FluidSpec{.stages = {Stage{.name = "production"}}}), {});
}

std::vector<std::string> warnings_of(const Diagnostics& diagnostics) {
    std::vector<std::string> warnings;
    for (const Diagnostic& entry : diagnostics.entries()) {
        if (entry.severity == Severity::warning) {
            warnings.push_back(format(entry));
        }
    }
    return warnings;
}

void bind_decks(py::module_& module) {
    py::class_<LoadedDeck>(module, "Deck", "A deck that was read without errors.")
        .def_property_readonly("kind", [](const LoadedDeck& d) { return kind_name(d.deck); })
        .def_property_readonly("title", [](const LoadedDeck& d) { return python_text(d.deck.title); })
        .def_property_readonly("total_steps", [](const LoadedDeck& d) { return total_steps(d.deck.stages()); })
        .def_property_readonly("directory", [](const LoadedDeck& d) { return python_text(d.deck.directory.string()); });
    module.def("substance", &substance_of, py::arg("deck"));
    module.def("read_file", &text_of_file, py::arg("path"));
    module.def("deck_text", &source_text, py::arg("source"), py::arg("pair"));
    module.def("value_text", &value_text, py::arg("value"), py::arg("name"));
    module.def("parse", &parsed, py::arg("name"), py::arg("source"), py::arg("settings"));
    module.def("load", &loaded, py::arg("name"), py::arg("source"), py::arg("settings"), py::arg("force"),
               py::arg("pair"));
    module.def("check", &checked, py::arg("deck"), py::arg("threads"), py::arg("simd"));
}

}  // namespace ljmd::python
