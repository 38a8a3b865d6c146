#pragma once

#include <vector>

#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Unwraps atoms frame by frame: of all periodic images of an atom, takes the one nearest to its position in the frame
/// before. Correct if no atom moves by half an edge or more between frames.
class FrameUnwrapper {
  public:
    /// Replace the positions by these images. The first frame is unchanged.
    /// @pre every frame has the same number of atoms
    void unwrap(Configuration& frame);

  private:
    std::vector<Vec3> before_;
};

}  // namespace ljmd
