#include <algorithm>
#include <bit>
#include <utility>

#include "execution/rank_messages.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/model/state.hpp"

// A state whose atoms are shared among ranks: how atoms pass from one to another.

namespace ljmd {

namespace {

constexpr auto stride = static_cast<std::size_t>(vector_stride);

}  // namespace

std::size_t State::packed_size() const {
    return 3 * stride + 5 + stride * registered_.size();
}

void State::pack(Index atom, std::vector<double>& numbers) const {
    const auto k = static_cast<std::size_t>(atom);
    const auto vector = [&](const AlignedVector<double>& from) {
        numbers.insert(numbers.end(), from.begin() + static_cast<std::ptrdiff_t>(stride * k),
                       from.begin() + static_cast<std::ptrdiff_t>(stride * (k + 1)));
    };
    vector(positions_);
    vector(velocities_);
    vector(forces_);
    const Eigen::Vector3i& image = images_[k];
    numbers.insert(numbers.end(), {masses_[k], std::bit_cast<double>(ids_[k]), static_cast<double>(image[0]),
                                   static_cast<double>(image[1]), static_cast<double>(image[2])});
    for (const Registered& extra : registered_) {
        vector(extra.data);
    }
}

const double* State::unpack(Index atom, const double* numbers) {
    const auto k = static_cast<std::size_t>(atom);
    const auto vector = [&](AlignedVector<double>& to) {
        std::copy_n(numbers, stride, to.begin() + static_cast<std::ptrdiff_t>(stride * k));
        numbers += stride;
    };
    vector(positions_);
    vector(velocities_);
    vector(forces_);
    masses_[k] = numbers[0];
    ids_[k] = std::bit_cast<Index>(numbers[1]);
    images_[k] = Eigen::Vector3d(numbers[2], numbers[3], numbers[4]).cast<int>();
    numbers += 5;
    for (Registered& extra : registered_) {
        vector(extra.data);
    }
    return numbers;
}

void State::resize(Index count) {
    count_ = count;
    const auto atoms = static_cast<std::size_t>(count);
    const auto set = [](auto& list, std::size_t size) {
        list.reserve(size > list.capacity() ? size + size / 32 : 0);  // resize alone may double it
        list.resize(size);
    };
    set(positions_, stride * atoms);
    set(velocities_, stride * atoms);
    set(forces_, stride * atoms);
    set(masses_, atoms);
    set(ids_, atoms);
    set(images_, atoms);
    for (Registered& extra : registered_) {
        set(extra.data, stride * atoms);
    }
    set_ghost_count(0);
}

void State::give_back_room() {
    positions_.shrink_to_fit();
    velocities_.shrink_to_fit();
    forces_.shrink_to_fit();
    masses_.shrink_to_fit();
    ids_.shrink_to_fit();
    images_.shrink_to_fit();
    spare_.room = {};
    for (Registered& extra : registered_) {
        extra.data.shrink_to_fit();
    }
}

void State::migrate(const std::vector<int>& destinations) {
    Ranks& ranks = execution_.ranks();
    if (static_cast<Index>(destinations.size()) != count_) {
        throw ContractViolation("every atom needs a rank to go to");
    }
    finish_kick();
    set_ghost_count(0);
    ++order_version_;
    const auto size = static_cast<std::size_t>(ranks.size());
    std::vector<std::vector<Index>> leaving(size);
    std::vector<Index> kept;
    for (Index i = 0; i < count_; ++i) {
        const int to = destinations[static_cast<std::size_t>(i)];
        (to == ranks.rank() ? kept : leaving[static_cast<std::size_t>(to)]).push_back(i);
    }
    std::vector<Ranks::Bytes> messages;
    double longest = 0.0;
    for (const std::vector<Index>& atoms : leaving) {
        messages.push_back(message_of(std::vector<Index>{std::ssize(atoms)}));
        longest = std::max(longest, static_cast<double>(atoms.size()));
    }
    ranks.largest({&longest, 1});
    const Index before = count_;
    std::vector<Index> place;  // of the next atom from each rank, after those that are here
    Index after = before;
    for (const Ranks::Bytes& message : ranks.exchange(std::move(messages))) {
        place.push_back(after);
        after += values_of<Index>(message).front();
    }
    resize(after);
    // Not all at once: when a run begins, nearly all atoms change their rank.
    constexpr Index atoms_under_way = 1 << 15;
    const Index piece = std::max<Index>(64, atoms_under_way / ranks.size());
    std::vector<double> numbers;
    for (Index first = 0; first < static_cast<Index>(longest); first += piece) {
        messages.assign(size, {});
        for (std::size_t to = 0; to < size; ++to) {
            numbers.clear();
            for (Index k = first; k < std::min<Index>(first + piece, std::ssize(leaving[to])); ++k) {
                pack(leaving[to][static_cast<std::size_t>(k)], numbers);
            }
            messages[to] = message_of(numbers);
        }
        const std::vector<Ranks::Bytes> arriving = ranks.exchange(std::move(messages));
        for (std::size_t from = 0; from < size; ++from) {
            numbers = values_of<double>(arriving[from]);
            for (const double* next = numbers.data(); next != numbers.data() + numbers.size();) {
                next = unpack(place[from]++, next);
            }
        }
    }
    // Each moves to a place that is not after its own, so nothing is overwritten that is still to be moved.
    Index atom = 0;
    const auto move = [&](Index from) {
        if (from != atom) {
            numbers.clear();
            pack(from, numbers);
            unpack(atom, numbers.data());
        }
        ++atom;
    };
    for (const Index from : kept) {
        move(from);
    }
    for (Index from = before; from < after; ++from) {
        move(from);
    }
    resize(atom);
    if (after > atom + atom / 4) {
        give_back_room();
    }
}

State State::gathered() const {
    Ranks& ranks = execution_.ranks();
    std::vector<Ranks::Bytes> messages(static_cast<std::size_t>(ranks.size()));
    std::vector<double> numbers;
    for (Index i = 0; i < count_; ++i) {
        pack(i, numbers);
    }
    messages.front() = message_of(numbers);
    const std::vector<Ranks::Bytes> received = ranks.exchange(std::move(messages));
    State all(ranks.is_root() ? total_ : 0, box_, execution_.alone());
    all.time = time;
    all.step = step;
    all.bath = bath;
    all.phase_ = phase_;
    all.kick_due_ = kick_due_;
    all.forces_current_ = forces_current_;
    all.order_version_ = order_version_;
    for (const Registered& extra : registered_) {
        static_cast<void>(all.register_vectors(extra.name));
    }
    Index atom = 0;
    for (const Ranks::Bytes& message : received) {
        const std::vector<double> of_rank = values_of<double>(message);
        for (const double* next = of_rank.data(); next != of_rank.data() + of_rank.size(); ++atom) {
            next = all.unpack(atom, next);
        }
    }
    return all;
}

}  // namespace ljmd
