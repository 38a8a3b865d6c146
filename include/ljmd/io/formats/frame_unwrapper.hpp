#pragma once

#include <vector>

#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Follows atoms through the walls of a periodic box, frame by frame: of all periodic images of an atom that is taken
/// which lies nearest to where it was. Right as long as no atom moves by half an edge from one frame to the next.
class FrameUnwrapper {
  public:
    /// Move the positions to these images. The first frame stays as it is.
    /// @pre as many atoms in every frame
    void unwrap(Configuration& frame);

  private:
    std::vector<Vec3> before_;
};

}  // namespace ljmd
