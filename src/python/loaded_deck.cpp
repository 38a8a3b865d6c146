#include "loaded_deck.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <type_traits>
#include <utility>
#include <variant>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/checked_run.hpp"
#include "ljmd/deck/deck_schema.hpp"
#include "ljmd/deck/deck_system.hpp"
#include "ljmd/input/deck_file.hpp"
#include "ljmd/input/deck_setting.hpp"
#include "pair.hpp"

namespace ljmd::python {

namespace {

py::dict table_of(const Table& table);

py::object value_of(const Value& value) {
    return std::visit(
        [](const auto& data) -> py::object {
            using T = std::remove_cvref_t<decltype(data)>;
            if constexpr (std::is_same_v<T, Array>) {
                py::list list;
                for (const Value& item : data) {
                    list.append(value_of(item));
                }
                return list;
            } else if constexpr (std::is_same_v<T, Table>) {
                return table_of(data);
            } else if constexpr (std::is_same_v<T, Date>) {
                return python_text(data.text);
            } else if constexpr (std::is_same_v<T, std::string>) {
                return python_text(data);
            } else {
                return py::cast(data);
            }
        },
        value.data);
}

py::dict table_of(const Table& table) {
    py::dict dict;
    for (const Entry& entry : table) {
        dict[python_text(entry.key)] = value_of(entry.value);
    }
    return dict;
}

/// The tables of a deck as dicts, unchecked.
py::dict parsed(const std::string& name, const std::string& text, const std::vector<std::string>& settings) {
    Diagnostics diagnostics;
    DeckFile file = parse_deck(name, text, diagnostics);
    diagnostics.throw_if_errors();
    for (const std::string& setting : settings) {
        apply_setting(file.table, setting, diagnostics);
    }
    diagnostics.throw_if_errors();
    return table_of(file.table);
}

/// @param pair  the pair potential of the calling program, if it gives one
std::unique_ptr<LoadedDeck> loaded(const std::string& name, const std::string& text,
                                   const std::vector<std::string>& settings, bool force, const PairOfPython* pair) {
    Diagnostics diagnostics;
    GivenParts given{.by = "Python"};
    if (pair != nullptr) {
        given.potential = pair->given();
    }
    auto deck = load_deck_text(name, text, settings, force, diagnostics, std::move(given));
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
    if (!loaded.deck.units) {
        return py::none();
    }
    const SubstanceUnits& units = *loaded.deck.units;
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
        .def_property_readonly("total_steps", [](const LoadedDeck& d) { return total_steps(d.deck.stages); })
        .def_property_readonly("directory", [](const LoadedDeck& d) { return python_text(d.deck.directory.string()); });
    module.def("substance", &substance_of, py::arg("deck"));
    module.def("read_file", &text_of_file, py::arg("path"));
    module.def("parse", &parsed, py::arg("name"), py::arg("text"), py::arg("settings"));
    module.def("load", &loaded, py::arg("name"), py::arg("text"), py::arg("settings"), py::arg("force"),
               py::arg("pair"));
    module.def("check", &checked, py::arg("deck"), py::arg("threads"), py::arg("simd"));
}

}  // namespace ljmd::python
