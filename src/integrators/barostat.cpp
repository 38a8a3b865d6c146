#include "ljmd/integrators/barostat.hpp"

#include "ljmd/core/registry.hpp"

namespace ljmd {

BarostatMethod find_barostat(const std::string& name) {
    return find_plugin(all_barostats(), name, "barostat");
}

}  // namespace ljmd
