#include "ljmd/deck/stage_sense.hpp"

#include "ljmd/deck/deck_stages.hpp"
#include "ljmd/deck/mistake_report.hpp"

namespace ljmd {

namespace {

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

void check_thermostat(const Section& section, const Stage& stage, const Section& root, Diagnostics& diagnostics) {
    if (!stage_temperature(section, root) && section.sound("temperature") && system_may_lack_temperature(root)) {
        diagnostics.error(section.section("thermostat").location("type"), "missing key 'temperature' in [[stage]]",
                          "the thermostat needs it; or give it in [system]");
    }
    if (!stage.thermostat->plugin.canonical && stage.sample) {
        diagnostics.warning(section.location("sample"),
                            "this stage is sampled under a thermostat that samples no ensemble");
    }
}

}  // namespace

void check_fluid_stages(const Section& root, Diagnostics& diagnostics) {
    const std::vector<Stage> stages = stages_of(root);
    report(stage_mistakes(stages), root, diagnostics);
    report(fluid_stage_mistakes(stages), root, diagnostics);
    for (std::size_t k = 0; k < stages.size(); ++k) {
        if (stages[k].thermostat) {
            check_thermostat(root.sections("stage")[k], stages[k], root, diagnostics);
        }
    }
}

}  // namespace ljmd
