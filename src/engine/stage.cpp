#include "ljmd/engine/stage.hpp"

namespace ljmd {

bool conserves_energy(const Stage& stage) {
    return !stage.barostat && (!stage.thermostat || stage.thermostat->plugin.canonical);
}

}  // namespace ljmd
