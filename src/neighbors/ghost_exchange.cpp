#include "neighbors/ghost_exchange.hpp"

#include <utility>

#include "execution/loops.hpp"

namespace ljmd {

namespace {

constexpr Index runs_per_block = 16;

}  // namespace

void GhostExchange::create(State& state, std::vector<Run> runs) {
    runs_ = std::move(runs);
    places_.clear();
    places_.reserve(runs_.size());
    count_ = 0;
    for (const Run& run : runs_) {
        places_.push_back(count_);
        count_ += run.count;
    }
    state.set_ghost_count(count_);
    update(state);
}

void GhostExchange::update(State& state) const {
    const ConstPaddedView r = padded(static_cast<const State&>(state).positions());
    PaddedView ghosts = padded(state.write_ghosts());
    for_each_block(state.execution(), static_cast<Index>(runs_.size()), runs_per_block, [&](Index first, Index last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
            const Run& run = runs_[k];
            const Eigen::Array4d shift(run.shift[0], run.shift[1], run.shift[2], 0.0);
            for (Index i = 0; i < run.count; ++i) {
                ghosts.col(places_[k] + i) = r.col(run.first + i) + shift;
            }
        }
    });
}

}  // namespace ljmd
