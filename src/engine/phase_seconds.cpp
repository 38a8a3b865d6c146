#include "ljmd/engine/phase_seconds.hpp"

#include <nlohmann/json.hpp>

namespace ljmd {

nlohmann::ordered_json phases_json(const PhaseSeconds& seconds) {
    return {{"force", seconds.force},         {"list", seconds.list},       {"sort", seconds.sort},
            {"integrate", seconds.integrate}, {"observe", seconds.observe}, {"write", seconds.write}};
}

}  // namespace ljmd
