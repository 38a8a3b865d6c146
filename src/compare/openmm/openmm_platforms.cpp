#include "openmm_platforms.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "ljmd/compare/openmm.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/io/files/input_file.hpp"

namespace ljmd {

namespace {

/// The folder of the platforms, from the environment or from the build.
std::string plugin_folder() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody writes the environment
    const char* named = std::getenv("OPENMM_PLUGIN_DIR");
    return named != nullptr ? named : LJMD_OPENMM_PLUGIN_DIR;
}

/// The regular files in it, sorted by name. OpenMM itself would open everything and block at pipes or files of /proc.
std::vector<std::string> plugin_files() {
    std::vector<std::string> names;
    if (input_is_directory(plugin_folder())) {
        for (const std::filesystem::path& path : files::list(plugin_folder())) {
            if (why_unreadable(path).empty()) {
                names.push_back(path.string());
            }
        }
    }
    return names;
}

/// Load the plug-ins in the folder, once. Those that cannot be loaded, for example for missing hardware, are skipped.
void load_plugins() {
    static const bool loaded = [] {
        for (const std::string& file : plugin_files()) {
            try {
                OpenMM::Platform::loadPluginLibrary(file);
            } catch (const OpenMM::OpenMMException&) {
                continue;
            }
        }
        return true;
    }();
    static_cast<void>(loaded);
}

}  // namespace

bool openmm_is_built_in() {
    return true;
}

std::string openmm_version() {
    return OpenMM::Platform::getOpenMMVersion();
}

std::vector<std::string> openmm_platforms() {
    load_plugins();
    const int count = OpenMM::Platform::getNumPlatforms();
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        names.push_back(OpenMM::Platform::getPlatform(i).getName());
    }
    return names;
}

OpenMM::Platform& openmm_platform(const std::string& name) {
    const std::vector<std::string> names = openmm_platforms();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        const std::string folder = plugin_folder();
        throw InputError(fmt::format(
            "OpenMM has no platform '{}'; loaded: {}\n  plug-ins were looked for in {}{}; the environment "
            "variable OPENMM_PLUGIN_DIR names another folder",
            name, fmt::join(names, ", "), folder, input_is_directory(folder) ? "" : ", which is not there"));
    }
    return OpenMM::Platform::getPlatformByName(name);
}

}  // namespace ljmd
