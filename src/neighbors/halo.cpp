#include "neighbors/halo.hpp"

#include <algorithm>
#include <utility>

#include "execution/rank_messages.hpp"

namespace ljmd {

void Halo::send(int to, std::vector<AtomRange> atoms) {
    Index count = 0;
    for (const AtomRange& range : atoms) {
        count += range.count();
    }
    if (count > 0) {
        sent_.push_back({to, std::move(atoms), std::vector<double>(static_cast<std::size_t>(vector_stride * count))});
    }
}

void Halo::receive(int from, Index atoms) {
    if (atoms > 0) {
        received_.push_back({from, {count(), count() + atoms}});
    }
}

void Halo::clear() {
    sent_.clear();
    received_.clear();
}

void Halo::begin_refresh(State& state) {
    const double* r = std::as_const(state).positions().data();
    std::vector<Ranks::Outgoing> outgoing;
    for (Sent& sent : sent_) {
        auto to = sent.positions.begin();
        for (const AtomRange& range : sent.atoms) {
            to = std::copy(r + vector_stride * range.first, r + vector_stride * range.last, to);
        }
        outgoing.push_back({sent.to, sent.positions});
    }
    double* ghosts = state.write_ghosts().data();
    std::vector<Ranks::Incoming> incoming;
    for (const Received& received : received_) {
        incoming.push_back({received.from,
                            {ghosts + vector_stride * received.ghosts.first,
                             static_cast<std::size_t>(vector_stride * received.ghosts.count())}});
    }
    state.execution().ranks().begin_exchange(outgoing, incoming);
    under_way_ = true;
}

void Halo::finish_refresh(Ranks& ranks) {
    if (under_way_) {
        ranks.finish_exchange();
        under_way_ = false;
    }
}

std::vector<std::vector<Halo::OnAtom>> Halo::return_forces(Ranks& ranks, const std::vector<OnAtom>& on_ghosts) const {
    const auto size = static_cast<std::size_t>(ranks.size());
    std::vector<std::vector<OnAtom>> to(size);
    for (const auto& [ghost, force] : on_ghosts) {
        const auto from = std::upper_bound(received_.begin(), received_.end(), ghost,
                                           [](Index g, const Received& each) { return g < each.ghosts.last; });
        to[static_cast<std::size_t>(from->from)].push_back({ghost - from->ghosts.first, force});
    }
    std::vector<Ranks::Bytes> messages;
    messages.reserve(size);
    for (const std::vector<OnAtom>& of_rank : to) {
        messages.push_back(message_of(of_rank));
    }
    const std::vector<Ranks::Bytes> received = ranks.exchange(std::move(messages));
    std::vector<std::vector<OnAtom>> found(size);
    for (std::size_t rank = 0; rank < size; ++rank) {
        found[rank] = values_of<OnAtom>(received[rank]);
    }
    // They name the atoms by their places in the message of positions.
    for (const Sent& sent : sent_) {
        std::vector<Index> atoms;
        for (const AtomRange& range : sent.atoms) {
            for (Index i = range.first; i < range.last; ++i) {
                atoms.push_back(i);
            }
        }
        for (OnAtom& each : found[static_cast<std::size_t>(sent.to)]) {
            each.atom = atoms[static_cast<std::size_t>(each.atom)];
        }
    }
    return found;
}

}  // namespace ljmd
