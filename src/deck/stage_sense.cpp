#include "ljmd/deck/stage_sense.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

#include "ljmd/core/text.hpp"

namespace ljmd {

namespace {

constexpr std::size_t longest_name = 64;

void check_name(const Section& stage, std::set<std::string>& names, Diagnostics& diagnostics) {
    const std::string& name = stage.text("name");
    if (!stage.sound("name")) {
        return;
    }
    if (name.empty() || printable(name, longest_name) != name) {
        diagnostics.error(stage.location("name"),
                          fmt::format("'name' in [[stage]] must be 1 to {} printable characters", longest_name));
    } else if (!names.insert(name).second) {
        diagnostics.error(stage.location("name"), fmt::format("two stages are called '{}'", name));
    }
}

/// Whether a missing temperature of [system] is allowed: a start from a file with velocities needs none. Otherwise its
/// absence is reported there.
bool system_may_lack_temperature(const Section& root) {
    if (!root.sound("system")) {
        return false;
    }
    const Section& system = root.section("system");
    return system.sound("temperature") && !system.has("lattice") &&
           !(system.has("velocities") && system.text("velocities") == "maxwell");
}

}  // namespace

std::optional<ThermostatMethod> thermostat_method(const Section& stage) {
    if (!stage.has("thermostat") || !stage.sound("thermostat") || !stage.section("thermostat").sound("type")) {
        return std::nullopt;
    }
    return find_thermostat(stage.section("thermostat").text("type"));
}

std::optional<double> stage_temperature(const Section& stage, const Section& root) {
    if (stage.has("temperature")) {
        return stage.number("temperature");
    }
    const bool has_system = root.has("system") && root.section("system").has("temperature");
    return has_system ? std::optional(root.section("system").number("temperature")) : std::nullopt;
}

void check_baths(const Section& stage, const Section& root, Diagnostics& diagnostics) {
    const auto thermostat = thermostat_method(stage);
    if (stage.has("barostat") && stage.sound("thermostat") && !(thermostat && thermostat->canonical)) {
        diagnostics.error(stage.location("barostat"), "a barostat needs a canonical thermostat beside it",
                          "e.g. thermostat = { type = \"stochastic-rescaling\" }");
    }
    if (!thermostat) {
        return;
    }
    const Location& type = stage.section("thermostat").location("type");
    if (thermostat->every_step && stage.sound("integrator") && stage.text("integrator") != "velocity-verlet") {
        diagnostics.error(type, fmt::format("the thermostat {} is a part of the steps of velocity-verlet; 'integrator' "
                                            "in [[stage]] is {}",
                                            thermostat->name, stage.text("integrator")));
    }
    const auto temperature = stage_temperature(stage, root);
    if (!temperature && stage.sound("temperature") && system_may_lack_temperature(root)) {
        diagnostics.error(type, "missing key 'temperature' in [[stage]]",
                          "the thermostat needs it; or give it in [system]");
    } else if (temperature == 0.0 && thermostat->canonical) {
        diagnostics.error(type, fmt::format("the thermostat {} needs a temperature above 0", thermostat->name),
                          "rescale can take it to 0");
    }
    if (!thermostat->canonical && stage.flag("sample")) {
        diagnostics.warning(stage.location("sample"),
                            "this stage is sampled under a thermostat that samples no ensemble");
    }
}

void check_stage_names(const std::vector<Section>& stages, Diagnostics& diagnostics) {
    std::set<std::string> names;
    double sum = 0.0;
    for (const Section& stage : stages) {
        check_name(stage, names, diagnostics);
        sum += static_cast<double>(stage.integer("steps"));
    }
    if (sum > 0x1p62) {
        diagnostics.error(stages.front().location("steps"), "the steps of all stages add up to more than 2^62");
    }
}

}  // namespace ljmd
