#include "ljmd/parallel/ghost_exchange.hpp"

namespace ljmd {

void GhostExchange::create(State& state, double halo) {
    images_.clear();
    const auto r = static_cast<const State&>(state).positions();
    const Vec3& edges = state.box().edges();
    for (int a = 0; a < 3; ++a) {
        const auto append_images = [&](Index owner, const Vec3& shift) {
            const double x = r(a, owner) + shift[a];
            for (double n = 1.0; x + n * edges[a] < edges[a] + halo; n += 1.0) {
                images_.push_back({owner, shift + n * edges[a] * Vec3::Unit(a)});
            }
            for (double n = 1.0; x - n * edges[a] >= -halo; n += 1.0) {
                images_.push_back({owner, shift - n * edges[a] * Vec3::Unit(a)});
            }
        };
        const std::size_t before = images_.size();
        for (Index i = 0; i < state.count(); ++i) {
            append_images(i, Vec3::Zero());
        }
        for (std::size_t k = 0; k < before; ++k) {
            const Image image = images_[k];  // a copy: append_images may move the vector
            append_images(image.owner, image.shift);
        }
    }
    state.set_ghost_count(static_cast<Index>(images_.size()));
    update(state);
}

void GhostExchange::update(State& state) const {
    const auto r = static_cast<const State&>(state).positions();
    auto ghosts = state.write_ghosts();
    for (std::size_t k = 0; k < images_.size(); ++k) {
        ghosts.col(static_cast<Index>(k)) = r.col(images_[k].owner) + images_[k].shift;
    }
}

}  // namespace ljmd
