#include "compare/openmm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "compare/openmm_expression.hpp"
#include "compare/openmm_module.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/program_module.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

ProgramModule module_file() {
    return {"OpenMM", "libopenmm-dev libopenmm-plugins", "ljmd_openmm.so"};
}

/// The folder of the platforms, from the environment or from the build.
std::string plugin_folder(const OpenmmModule& openmm) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody writes the environment
    const char* named = std::getenv("OPENMM_PLUGIN_DIR");
    return named != nullptr ? named : openmm.plugin_folder();
}

/// Load the regular files in it, in the order of their names. OpenMM itself would open everything and block at pipes or
/// files of /proc.
void load_plugins(const OpenmmModule& openmm) {
    if (input_is_directory(plugin_folder(openmm))) {
        for (const std::filesystem::path& path : files::list(plugin_folder(openmm))) {
            if (why_unreadable(path).empty()) {
                openmm.load_plugin(path.string());
            }
        }
    }
}

/// The module with its platforms, loaded once. @throws InputError
const OpenmmModule& loaded() {
    static const OpenmmModule& openmm = []() -> const OpenmmModule& {
        const OpenmmModule& module = *module_file().function<decltype(ljmd_openmm)>(openmm_module_function)();
        load_plugins(module);
        return module;
    }();
    return openmm;
}

/// @throws InputError that lists the loaded ones
void require_platform(const std::string& name) {
    const std::vector<std::string> names = openmm_platforms();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        const std::string folder = plugin_folder(loaded());
        throw InputError(fmt::format(
            "OpenMM has no platform '{}'; loaded: {}\n  plug-ins were looked for in {}{}; the environment "
            "variable OPENMM_PLUGIN_DIR names another folder",
            name, fmt::join(names, ", "), folder, input_is_directory(folder) ? "" : ", which is not there"));
    }
}

}  // namespace

std::filesystem::path openmm_module() {
    return module_file().path();
}

bool openmm_is_built_in() {
    return module_file().is_there();
}

std::string openmm_version() {
    return loaded().version();
}

std::vector<std::string> openmm_platforms() {
    return loaded().platforms();
}

OpenmmFluid openmm_fluid(const Fluid& fluid) {
    const PairPotential& potential = fluid.potential;
    return {fluid, openmm_expression(potential), openmm_formula(potential),
            potential.untruncated(potential.cutoff().radius)};
}

std::unique_ptr<Peer> make_openmm_peer(const Fluid& fluid, const OpenmmOptions& options) {
    require_platform(options.platform);
    return loaded().peer(openmm_fluid(fluid), options);
}

OpenmmXml openmm_xml(const Fluid& fluid, double time_step) {
    return loaded().xml(openmm_fluid(fluid), time_step);
}

}  // namespace ljmd
