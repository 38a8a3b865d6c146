#pragma once

#include <OpenMM.h>

#include <string>

namespace ljmd {

/// A loaded platform, by name. @throws InputError that lists the loaded ones
[[nodiscard]] OpenMM::Platform& openmm_platform(const std::string& name);

}  // namespace ljmd
