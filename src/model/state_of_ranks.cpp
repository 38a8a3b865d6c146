#include <algorithm>
#include <bit>
#include <utility>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/execution/rank_messages.hpp"
#include "ljmd/model/state.hpp"

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
    velocities_.resize(stride * atoms);
    forces_.resize(stride * atoms);
    masses_.resize(atoms);
    ids_.resize(atoms);
    images_.resize(atoms);
    for (Registered& extra : registered_) {
        extra.data.resize(stride * atoms);
    }
    set_ghost_count(0);
}

void State::migrate(const std::vector<int>& destinations) {
    Ranks& ranks = execution_.ranks();
    if (static_cast<Index>(destinations.size()) != count_) {
        throw ContractViolation("every atom needs a rank to go to");
    }
    finish_kick();
    set_ghost_count(0);
    ++order_version_;
    std::vector<std::vector<double>> leaving(static_cast<std::size_t>(ranks.size()));
    std::vector<double> staying;
    for (Index i = 0; i < count_; ++i) {
        const int to = destinations[static_cast<std::size_t>(i)];
        if (to != ranks.rank()) {
            pack(i, leaving[static_cast<std::size_t>(to)]);
        }
    }
    std::vector<Index> kept;
    for (Index i = 0; i < count_; ++i) {
        if (destinations[static_cast<std::size_t>(i)] == ranks.rank()) {
            kept.push_back(i);
        }
    }
    std::vector<Ranks::Bytes> messages;
    messages.reserve(leaving.size());
    for (const std::vector<double>& numbers : leaving) {
        messages.push_back(message_of(numbers));
    }
    const std::vector<Ranks::Bytes> arriving = ranks.exchange(std::move(messages));
    // Each moves to a place that is not after its own, so nothing is overwritten that is still to be moved.
    Index atom = 0;
    for (const Index from : kept) {
        if (from != atom) {
            staying.clear();
            pack(from, staying);
            unpack(atom, staying.data());
        }
        ++atom;
    }
    std::size_t bytes = 0;
    for (const Ranks::Bytes& message : arriving) {
        bytes += message.size();
    }
    resize(atom + static_cast<Index>(bytes / (packed_size() * sizeof(double))));
    for (const Ranks::Bytes& message : arriving) {
        const std::vector<double> numbers = values_of<double>(message);
        for (const double* next = numbers.data(); next != numbers.data() + numbers.size(); ++atom) {
            next = unpack(atom, next);
        }
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

void State::archive(Archive& a) {
    finish_kick();
    const Ranks& ranks = execution_.ranks();
    if (ranks.alone()) {
        archive_all(a);
        return;
    }
    if (!a.reading()) {
        State all = gathered();
        if (ranks.is_root()) {
            all.archive_all(a);
        }
        return;
    }
    State all(total_, box_, execution_.alone());
    all.archive_all(a);
    const Share share = even_share(total_, ranks);
    registered_.clear();
    for (const Registered& extra : all.registered_) {
        static_cast<void>(register_vectors(extra.name));
    }
    resize(share.count());
    std::vector<double> numbers;
    for (Index i = 0; i < share.count(); ++i) {
        numbers.clear();
        all.pack(share.first + i, numbers);
        unpack(i, numbers.data());
    }
    time = all.time;
    step = all.step;
    bath = all.bath;
    phase_ = all.phase_;
    forces_current_ = all.forces_current_;
    ++order_version_;
}

}  // namespace ljmd
