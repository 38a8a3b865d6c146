#include "ljmd/core/build_info.hpp"

#include "core/version.hpp"

namespace ljmd {

const BuildInfo& build_info() {
    static const BuildInfo info{LJMD_VERSION,          LJMD_COMMIT,     LJMD_COMPILER,
                                LJMD_COMPILER_VERSION, LJMD_BUILD_TYPE, LJMD_FLAGS};
    return info;
}

}  // namespace ljmd
