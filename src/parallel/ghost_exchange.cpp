#include "ljmd/parallel/ghost_exchange.hpp"

#include "ljmd/core/threads.hpp"

namespace ljmd {

void GhostExchange::create(State& state, double halo) {
    images_.clear();
    const auto r = static_cast<const State&>(state).positions();
    const Vec3& edges = state.box().edges();
    for (int a = 0; a < 3; ++a) {
        const auto append_images = [&](std::vector<Image>& images, Index owner, const Vec3& shift) {
            const double x = r(a, owner) + shift[a];
            for (double n = 1.0; x + n * edges[a] < edges[a] + halo; n += 1.0) {
                images.push_back({owner, shift + n * edges[a] * Vec3::Unit(a)});
            }
            for (double n = 1.0; x - n * edges[a] >= -halo; n += 1.0) {
                images.push_back({owner, shift - n * edges[a] * Vec3::Unit(a)});
            }
        };
        // Of the atoms first, then of the images along the axes before.
        const Index candidates = state.count() + static_cast<Index>(images_.size());
        std::vector<std::vector<Image>> found(static_cast<std::size_t>((candidates + usual_block - 1) / usual_block));
        for_each_block(candidates, usual_block, [&](Index first, Index last) {
            auto& images = found[static_cast<std::size_t>(first / usual_block)];
            for (Index k = first; k < last; ++k) {
                if (k < state.count()) {
                    append_images(images, k, Vec3::Zero());
                } else {
                    const Image& image = images_[static_cast<std::size_t>(k - state.count())];
                    append_images(images, image.owner, image.shift);
                }
            }
        });
        for (const auto& images : found) {
            images_.insert(images_.end(), images.begin(), images.end());
        }
    }
    state.set_ghost_count(static_cast<Index>(images_.size()));
    update(state);
}

void GhostExchange::update(State& state) const {
    const double* r = static_cast<const State&>(state).positions().data();
    double* ghosts = state.write_ghosts().data();
    for_each_index(count(), [&](Index k) {
        const Image& image = images_[static_cast<std::size_t>(k)];
        for (int a = 0; a < 3; ++a) {
            ghosts[4 * k + a] = r[4 * image.owner + a] + image.shift[a];
        }
    });
}

}  // namespace ljmd
