#include "ljmd/engine/stage.hpp"

#include "ljmd/integrators/thermostat.hpp"

namespace ljmd {

bool conserves_energy(const Stage& stage) {
    if (stage.section.has("barostat")) {
        return false;
    }
    return !stage.section.has("thermostat") ||
           find_thermostat(stage.section.section("thermostat").text("type")).canonical;
}

}  // namespace ljmd
