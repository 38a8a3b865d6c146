#include "ljmd/detail/engine/phase_seconds.hpp"

namespace ljmd {

Data phases_data(const PhaseSeconds& seconds) {
    return {{"force", seconds.force},         {"list", seconds.list},       {"sort", seconds.sort},
            {"integrate", seconds.integrate}, {"observe", seconds.observe}, {"write", seconds.write}};
}

}  // namespace ljmd
