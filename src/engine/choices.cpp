#include "ljmd/engine/choices.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/core/registry.hpp"
#include "ljmd/core/section.hpp"

namespace ljmd {

namespace {

Value value_of(const PlainValue& plain) {
    Value value;
    if (const auto* numbers = std::get_if<std::vector<double>>(&plain)) {
        Array array;
        for (const double number : *numbers) {
            array.push_back({number, {}});
        }
        value.data = array;
        return value;
    }
    std::visit(
        [&value](const auto& any) {
            if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(any)>, std::vector<double>>) {
                value.data = any;
            }
        },
        plain);
    return value;
}

/// Checked as a table of a deck is, but for its place.
template <class Plugin>
auto chosen(const Plugin& plugin, const Settings& settings) {
    Table table;
    for (const auto& [key, value] : settings) {
        table.push_back({key, {}, value_of(value)});
    }
    for (std::size_t k = 0; k < settings.size(); ++k) {
        for (std::size_t other = 0; other < k; ++other) {
            if (settings[k].first == settings[other].first) {
                throw InputError("'" + settings[k].first + "' in " + plugin.name + " is given twice");
            }
        }
    }
    Diagnostics diagnostics;
    const Section section = validate(table, {}, Schema(plugin.name, keys_of(plugin)), std::nullopt, diagnostics);
    std::string mistakes;
    for (const Diagnostic& entry : diagnostics.entries()) {
        mistakes += (mistakes.empty() ? "" : "\n") + entry.message + (entry.hint.empty() ? "" : ": " + entry.hint);
    }
    if (!mistakes.empty()) {
        throw InputError(mistakes);
    }
    return choose(plugin, section);
}

}  // namespace

ChosenIntegrator integrator(const std::string& name, const Settings& settings) {
    return chosen(find_integrator(name), settings);
}

ChosenThermostat thermostat(const std::string& name, const Settings& settings) {
    return chosen(find_thermostat(name), settings);
}

ChosenBarostat barostat(const std::string& name, const Settings& settings) {
    return chosen(find_barostat(name), settings);
}

ChosenAnalysis analysis(const std::string& name, const Settings& settings) {
    return chosen(find_plugin(all_analyses(), name, "analysis"), settings);
}

}  // namespace ljmd
