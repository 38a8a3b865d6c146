#include "compare/openmm_module.hpp"

#include <OpenMM.h>

#include <utility>

#include "compare/openmm/linked_openmm.hpp"

namespace ljmd {

namespace {

class LinkedOpenmm : public OpenmmModule {
  public:
    [[nodiscard]] std::string version() const override { return OpenMM::Platform::getOpenMMVersion(); }

    [[nodiscard]] std::string plugin_folder() const override { return LJMD_OPENMM_PLUGIN_DIR; }

    void load_plugin(const std::string& file) const override {
        try {
            OpenMM::Platform::loadPluginLibrary(file);
        } catch (const OpenMM::OpenMMException&) {
        }
    }

    [[nodiscard]] std::vector<std::string> platforms() const override {
        const int count = OpenMM::Platform::getNumPlatforms();
        std::vector<std::string> names;
        names.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            names.push_back(OpenMM::Platform::getPlatform(i).getName());
        }
        return names;
    }

    [[nodiscard]] std::unique_ptr<Peer> peer(OpenmmFluid fluid, const OpenmmOptions& options) const override {
        return linked_openmm_peer(std::move(fluid), options);
    }

    [[nodiscard]] OpenmmXml xml(const OpenmmFluid& fluid, double time_step) const override {
        return linked_openmm_xml(fluid, time_step);
    }
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const OpenmmModule* ljmd_openmm() {
    static const LinkedOpenmm module;
    return &module;
}

}  // namespace ljmd
