#include "ljmd/integrators/integrator.hpp"

#include "ljmd/core/registry.hpp"

namespace ljmd {

IntegratorMethod find_integrator(const std::string& name) {
    return find_plugin(all_integrators(), name, "integrator");
}

}  // namespace ljmd
