#pragma once

#include <string>
#include <vector>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// Names of plug-ins (any type with a `name`).
template <class Plugin>
std::vector<std::string> plugin_names(const std::vector<Plugin>& plugins) {
    std::vector<std::string> names;
    names.reserve(plugins.size());
    for (const Plugin& plugin : plugins) {
        names.push_back(plugin.name);
    }
    return names;
}

/// The plug-in with this name.
/// @param what  kind of plug-in for the message, e.g. "integrator"
/// @throws InputError listing all names, if there is none
template <class Plugin>
Plugin find_plugin(const std::vector<Plugin>& plugins, const std::string& name, const std::string& what) {
    for (const Plugin& plugin : plugins) {
        if (plugin.name == name) {
            return plugin;
        }
    }
    std::string allowed;
    for (const std::string& known : plugin_names(plugins)) {
        allowed += (allowed.empty() ? "" : ", ") + known;
    }
    throw InputError("unknown " + what + " '" + name + "', allowed: " + allowed);
}

}  // namespace ljmd
