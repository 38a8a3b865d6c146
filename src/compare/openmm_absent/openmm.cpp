#include "ljmd/compare/openmm.hpp"

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

[[noreturn]] void absent() {
    throw InputError(
        "this ljmd was built without OpenMM; install it (Debian: apt-get install libopenmm-dev libopenmm-plugins) "
        "and build again");
}

}  // namespace

bool openmm_is_built_in() {
    return false;
}

std::string openmm_version() {
    return {};
}

std::vector<std::string> openmm_platforms() {
    return {};
}

std::unique_ptr<Peer> make_openmm_peer(const Fluid&, const OpenmmOptions&) {
    absent();
}

OpenmmXml openmm_xml(const Fluid&, double) {
    absent();
}

}  // namespace ljmd
