#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/options/description.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "ljmd/detail/options/section.hpp"
#include "ljmd/options/settings.hpp"

namespace ljmd {

/// A plug-in by its name, with the options that are given: {"langevin", {{"time", 0.5}}}. Options that are
/// left out have their defaults. A plain value: it is compared, copied and written without the plug-in.
struct Choice {
    std::string name;
    Settings settings = {};

    friend bool operator==(const Choice&, const Choice&) = default;
};

/// The plug-in of a choice, with its options.
/// @param what  kind of plug-in for messages, e.g. "integrator"
/// @throws InputError  an unknown name or key, a key given twice, a value of another type or outside its range
template <class Plugin>
[[nodiscard]] auto chosen(const std::vector<Plugin>& plugins, const Choice& choice, const std::string& what) {
    const Plugin plugin = find_plugin(plugins, choice.name, what);
    return choose(plugin, checked_settings(plugin.name, keys_of(plugin), choice.settings));
}

/// The choice with all its options.
template <class Plugin, class Options>
[[nodiscard]] Choice choice_of(const Chosen<Plugin, Options>& made) {
    return {made.plugin.name, made.values};
}

}  // namespace ljmd
