#include "model/atoms_by_id.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <numeric>
#include <utility>

#include "execution/rank_messages.hpp"

namespace ljmd {

namespace {

/// What rank 0 asks the others for.
enum class Wanted : std::int64_t { nothing, pieces, all };

struct Request {
    Wanted wanted = Wanted::nothing;
    AtomParts parts;
    Index atoms_of_piece = 0;
};

/// Tell all ranks what rank 0 wants. Collective.
Request agreed(Ranks& ranks, const Request& request) {
    std::array<std::int64_t, 6> words{};
    if (ranks.is_root()) {
        words = {static_cast<std::int64_t>(request.wanted),
                 request.parts.positions ? 1 : 0,
                 request.parts.velocities ? 1 : 0,
                 request.parts.forces ? 1 : 0,
                 request.parts.masses ? 1 : 0,
                 request.atoms_of_piece};
    }
    ranks.sum(words);
    return {Wanted{words[0]}, {words[1] != 0, words[2] != 0, words[3] != 0, words[4] != 0}, words[5]};
}

/// The atoms of one rank in the order of ids.
class Sorted {
  public:
    Sorted(const State& state, const AtomParts& parts)
        : state_(state), parts_(parts), order_(static_cast<std::size_t>(state.count())) {
        std::iota(order_.begin(), order_.end(), Index{0});
        std::ranges::sort(order_, {}, [&](Index i) { return id(i); });
    }

    /// Numbers of the atoms with ids below `last` that have not been packed yet: id, then the parts.
    std::vector<double> pack(Index last) {
        std::vector<double> numbers;
        const auto vector = [&](const auto& v) { numbers.insert(numbers.end(), {v[0], v[1], v[2]}); };
        for (; next_ < order_.size() && id(order_[next_]) < last; ++next_) {
            const Index i = order_[next_];
            numbers.push_back(static_cast<double>(id(i)));
            if (parts_.positions) {
                vector(state_.positions().col(i));
                vector(state_.image(i).cast<double>());
            }
            if (parts_.velocities) {
                vector(state_.velocities().col(i));
            }
            if (parts_.forces) {
                vector(state_.forces().col(i));
            }
            if (parts_.masses) {
                numbers.push_back(state_.masses()[static_cast<std::size_t>(i)]);
            }
        }
        return numbers;
    }

  private:
    [[nodiscard]] Index id(Index i) const { return state_.ids()[static_cast<std::size_t>(i)]; }

    const State& state_;
    AtomParts parts_;
    std::vector<Index> order_;
    std::size_t next_ = 0;
};

AtomPiece room(const AtomParts& parts, Index first, Index count) {
    const auto size = [count](bool wanted) { return wanted ? static_cast<std::size_t>(count) : 0; };
    AtomPiece piece{
        .first = first, .count = count, .positions = {}, .images = {}, .velocities = {}, .forces = {}, .masses = {}};
    piece.positions.resize(size(parts.positions));
    piece.images.resize(size(parts.positions));
    piece.velocities.resize(size(parts.velocities));
    piece.forces.resize(size(parts.forces));
    piece.masses.resize(size(parts.masses));
    return piece;
}

/// The inverse of Sorted::pack().
void unpack(const std::vector<double>& numbers, const AtomParts& parts, AtomPiece& piece) {
    const double* next = numbers.data();
    const auto vector = [&next] {
        next += 3;
        return Vec3(next[-3], next[-2], next[-1]);
    };
    while (next != numbers.data() + numbers.size()) {
        const auto k = static_cast<std::size_t>(static_cast<Index>(*next++) - piece.first);
        if (parts.positions) {
            piece.positions[k] = vector();
            piece.images[k] = vector().cast<int>();
        }
        if (parts.velocities) {
            piece.velocities[k] = vector();
        }
        if (parts.forces) {
            piece.forces[k] = vector();
        }
        if (parts.masses) {
            piece.masses[k] = *next++;
        }
    }
}

/// What all ranks do while rank 0 visits. @param look  null at the others
void pass_pieces(const State& state, const Request& request, const std::function<void(const AtomPiece&)>* look) {
    Ranks& ranks = state.execution().ranks();
    Sorted sorted(state, request.parts);
    std::exception_ptr failure;  // the others cannot know of it: the exchange goes on to its end
    for (Index first = 0; first < state.total(); first += request.atoms_of_piece) {
        const Index last = std::min(first + request.atoms_of_piece, state.total());
        std::vector<Ranks::Bytes> messages(static_cast<std::size_t>(ranks.size()));
        messages.front() = message_of(sorted.pack(last));
        const std::vector<Ranks::Bytes> received = ranks.exchange(std::move(messages));
        if (look == nullptr || failure) {
            continue;
        }
        try {
            AtomPiece piece = room(request.parts, first, last - first);
            for (const Ranks::Bytes& message : received) {
                unpack(values_of<double>(message), request.parts, piece);
            }
            (*look)(piece);
        } catch (...) {
            failure = std::current_exception();
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

/// Without other ranks atoms need not be packed.
void pass_pieces_alone(const State& state, const Request& request, const std::function<void(const AtomPiece&)>& look) {
    const std::vector<Index> index_of = state.index_of();
    for (Index first = 0; first < state.total(); first += request.atoms_of_piece) {
        const Index count = std::min(request.atoms_of_piece, state.total() - first);
        AtomPiece piece = room(request.parts, first, count);
        const std::span<const Index> atoms(index_of.data() + first, static_cast<std::size_t>(count));
        for (std::size_t k = 0; k < atoms.size(); ++k) {
            const Index i = atoms[k];
            if (request.parts.positions) {
                piece.positions[k] = state.positions().col(i);
                piece.images[k] = state.image(i);
            }
            if (request.parts.velocities) {
                piece.velocities[k] = state.velocities().col(i);
            }
            if (request.parts.forces) {
                piece.forces[k] = state.forces().col(i);
            }
            if (request.parts.masses) {
                piece.masses[k] = state.masses()[static_cast<std::size_t>(i)];
            }
        }
        look(piece);
    }
}

}  // namespace

std::vector<Vec3> AtomPiece::unwrapped(const State& state) const {
    const Vec3 edges = state.has_box() ? state.box().edges() : Vec3::Zero();
    std::vector<Vec3> places = positions;
    for (std::size_t k = 0; k < places.size(); ++k) {
        places[k] += images[k].cast<double>().cwiseProduct(edges);
    }
    return places;
}

void visit_by_id(const State& state, const AtomParts& parts, const std::function<void(const AtomPiece&)>& look,
                 Index atoms_of_piece) {
    const Request request{Wanted::pieces, parts, atoms_of_piece};
    Ranks& ranks = state.execution().ranks();
    if (ranks.alone()) {
        pass_pieces_alone(state, request, look);
        return;
    }
    pass_pieces(state, agreed(ranks, request), &look);
}

State gathered_for_root(const State& state) {
    Ranks& ranks = state.execution().ranks();
    if (!ranks.alone()) {
        static_cast<void>(agreed(ranks, {Wanted::all, {}, 0}));
    }
    return state.gathered();
}

void look_by_id(const State& state, const std::function<void()>& look) {
    Ranks& ranks = state.execution().ranks();
    if (ranks.is_root()) {
        look();
        if (!ranks.alone()) {
            static_cast<void>(agreed(ranks, {}));
        }
        return;
    }
    for (;;) {
        const Request request = agreed(ranks, {});
        if (request.wanted == Wanted::nothing) {
            return;
        }
        if (request.wanted == Wanted::pieces) {
            pass_pieces(state, request, nullptr);
        } else {
            static_cast<void>(state.gathered());
        }
    }
}

}  // namespace ljmd
