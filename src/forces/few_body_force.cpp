#include "ljmd/forces/few_body_force.hpp"

#include "ljmd/core/registry.hpp"

namespace ljmd {

FewBodyForceMethod find_few_body_force(const std::string& name) {
    return find_plugin(all_few_body_forces(), name, "few-body force");
}

}  // namespace ljmd
