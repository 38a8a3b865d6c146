#pragma once

#include <OpenMM.h>

#include <string>

namespace ljmd {

/// A platform that is loaded, by its name. @throws InputError that lists those loaded
[[nodiscard]] OpenMM::Platform& openmm_platform(const std::string& name);

}  // namespace ljmd
