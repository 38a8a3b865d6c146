#include "io/formats/frame_unwrapper.hpp"

namespace ljmd {

void FrameUnwrapper::unwrap(Configuration& frame) {
    for (std::size_t k = 0; k < before_.size(); ++k) {
        const Vec3 moved = frame.positions[k] - before_[k];
        const Vec3 edges = moved.cwiseQuotient(frame.edges).array().round();
        frame.positions[k] -= edges.cwiseProduct(frame.edges);
    }
    before_ = frame.positions;
}

}  // namespace ljmd
