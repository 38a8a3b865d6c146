#include "ljmd/detail/model/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "core/resize_tightly.hpp"
#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/core/archived_count.hpp"
#include "model/shared_archive.hpp"
#include "model/time_over_mass.hpp"

namespace ljmd {

namespace {

constexpr auto stride = static_cast<std::size_t>(vector_stride);

/// An atom does not diffuse this many edges away from its box.
constexpr double max_crossings = 1e6;

VectorView view(AlignedVector<double>& data, Index first, Index count) {
    return {data.data() + stride * static_cast<std::size_t>(first), 3, count};
}

ConstVectorView view(const AlignedVector<double>& data, Index count) {
    return {data.data(), 3, count};
}

/// Reorder groups of `width` numbers: group k becomes the former group order[k].
/// @pre `spare` has room for all bytes of `data`
template <std::size_t width, class Vector>
void permute(const Execution& execution, Vector& data, const std::vector<Index>& order, std::byte* spare) {
    constexpr std::size_t bytes = width * sizeof(typename Vector::value_type);
    auto* moved = reinterpret_cast<std::byte*>(data.data());
    for_each_range(execution, static_cast<Index>(order.size()), [&](Index first, Index last) {
        std::memcpy(spare + bytes * static_cast<std::size_t>(first), moved + bytes * static_cast<std::size_t>(first),
                    bytes * static_cast<std::size_t>(last - first));
    });
    for_each_index(execution, static_cast<Index>(order.size()), [&](Index k) {
        const auto to = static_cast<std::size_t>(k);
        std::memcpy(moved + bytes * to, spare + bytes * static_cast<std::size_t>(order[to]), bytes);
    });
}

/// Whether the padding of each vector is zero, as it must be.
bool padding_is_zero(std::span<const double> data) {
    for (std::size_t i = stride - 1; i < data.size(); i += stride) {
        if (data[i] != 0.0) {
            return false;
        }
    }
    return true;
}

std::size_t checked(Index count) {
    if (count < 0) {
        throw ContractViolation(fmt::format("a state of {} atoms", count));
    }
    return static_cast<std::size_t>(count);
}

}  // namespace

State::State(Index count, std::optional<Box> box, Execution execution)
    : execution_(std::move(execution)),
      total_(static_cast<Index>(checked(count))),
      count_(even_share(total_, execution_.ranks()).count()),
      box_(std::move(box)),
      positions_(),
      velocities_(stride * checked(count_)),
      forces_(stride * checked(count_)),
      masses_(checked(count_), 1.0),
      ids_(checked(count_)),
      images_(checked(count_), Eigen::Vector3i::Zero()) {
    std::iota(ids_.begin(), ids_.end(), even_share(total_, execution_.ranks()).first);
    set_ghost_count(0);
}

const Box& State::box() const {
    if (!box_) {
        throw ContractViolation("this system has no box");
    }
    return *box_;
}

void State::rescale_to(const Box& box) {
    const Vec3 factor = box.edges().array() / this->box().edges().array();
    wrap();
    box_ = box;
    set_ghost_count(0);
    auto r = write_positions();
    for (Index i = 0; i < count_; ++i) {
        r.col(i) = box.snap(r.col(i).cwiseProduct(factor));
    }
}

ConstVectorView State::positions() const {
    return view(positions_, count_);
}
ConstVectorView State::positions_and_ghosts() const {
    return view(positions_, count_ + ghost_count_);
}
ConstVectorView State::velocities() const {
    if (kick_due_ != 0.0) {
        throw ContractViolation("velocities were asked for while a kick is pending");
    }
    return view(velocities_, count_);
}
ConstVectorView State::forces() const {
    return view(forces_, count_);
}

VectorView State::write_positions() {
    forces_current_ = false;
    phase_ = {};
    return view(positions_, 0, count_);
}
VectorView State::write_velocities() {
    finish_kick();
    phase_ = {};
    return view(velocities_, 0, count_);
}
VectorView State::write_forces() {
    finish_kick();
    return view(forces_, 0, count_);
}
std::vector<double>& State::write_masses() {
    finish_kick();
    return masses_;
}

void State::kick(double dt) {
    finish_kick();
    phase_ = {};
    kick_due_ = dt;
}

double State::take_kick() {
    return std::exchange(kick_due_, 0.0);
}

void State::finish_kick() {
    if (kick_due_ == 0.0) {
        return;
    }
    const double dt = std::exchange(kick_due_, 0.0);
    for_each_range(execution_, count_, [&](Index first, Index last) {
        TimeOverMass factor(dt);
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
            Eigen::Map<Eigen::Array4d>(velocities_.data() + stride * i) +=
                factor(masses_[i]) * Eigen::Map<const Eigen::Array4d>(forces_.data() + stride * i);
        }
    });
}

VectorView State::write_ghosts() {
    return view(positions_, count_, ghost_count_);
}

void State::wrap() {
    auto r = view(positions_, 0, count_);
    const auto is_inside = [&](Index i) {
        return (r.col(i).array() >= 0.0).all() && (r.col(i).array() < box().edges().array()).all();
    };
    // No atom is moved unless all can be: what a failing run leaves must not depend on who found it first.
    fail_together(execution_.ranks(), [&] {
        for_each_index(execution_, count_, [&](Index i) {
            if (is_inside(i)) {
                return;  // nearly always
            }
            const Vec3 n = box().crossings(r.col(i));
            if ((n.array().abs() < max_crossings).all()) {  // false for NaN as well; maxCoeff may ignore NaN
                return;
            }
            const Vec3 outside = (r.col(i).array() - 0.5 * box().edges().array()).abs() - 0.5 * box().edges().array();
            const std::string how = r.col(i).allFinite()
                                        ? fmt::format("has left its box by {:.3g} sigma", outside.maxCoeff())
                                        : "was pushed out of the range of numbers";
            throw PhysicsError(
                fmt::format("atom {} {}: the run has blown up. Is the time step too large, or do atoms overlap at "
                            "the start?",
                            ids_[static_cast<std::size_t>(i)] + 1, how));
        });
    });
    for_each_index(execution_, count_, [&](Index i) {
        if (!is_inside(i)) {
            const Vec3 n = box().crossings(r.col(i));
            r.col(i) -= n.cwiseProduct(box().edges());
            images_[static_cast<std::size_t>(i)] += n.cast<int>();
        }
    });
}

Vec3 State::unwrapped(Index i) const {
    return positions().col(i) + image(i).cast<double>().cwiseProduct(box_ ? box_->edges() : Vec3::Zero());
}

void State::reorder(const std::vector<Index>& order) {
    if (static_cast<Index>(order.size()) != count_) {
        throw ContractViolation("a new order must contain every atom once");
    }
    finish_kick();
    ++order_version_;
    resize_tightly(spare_.room, stride * order.size());
    auto* spare = reinterpret_cast<std::byte*>(spare_.room.data());
    permute<stride>(execution_, positions_, order, spare);
    permute<stride>(execution_, velocities_, order, spare);
    if (forces_current_) {
        permute<stride>(execution_, forces_, order, spare);
    }
    permute<1>(execution_, masses_, order, spare);
    permute<1>(execution_, ids_, order, spare);
    permute<1>(execution_, images_, order, spare);
    for (auto& extra : registered_) {
        permute<stride>(execution_, extra.data, order, spare);
    }
    set_ghost_count(0);
}

void State::set_ghost_count(Index count) {
    resize_tightly(positions_, stride * (checked(count_) + checked(count)));
    ghost_count_ = count;
}

void State::Phase::archive(Archive& a) {
    a(integrator, steps);
}

void State::archive(Archive& a) {
    finish_kick();
    Ranks& ranks = execution_.ranks();
    SharedArchive atoms(a, ranks, count_, total_);
    if (a.reading()) {
        read(a, atoms);
        return;
    }
    const auto number = static_cast<std::size_t>(count_);
    const auto vectors = [&](const AlignedVector<double>& data) {
        atoms.write(std::span<const double>(data.data(), stride * number), vector_stride);
    };
    const bool writes = ranks.is_root();
    if (writes) {
        a.mark("state");
        bool bounded = box_.has_value();
        Vec3 edges = bounded ? box_->edges() : Vec3::Zero();
        a(total_, bounded, edges);
    }
    vectors(positions_);
    vectors(velocities_);
    vectors(forces_);
    atoms.write(std::span<const double>(masses_), 1);
    atoms.write(std::span<const Index>(ids_), 1);
    static_assert(sizeof(Eigen::Vector3i) == 3 * sizeof(int));
    atoms.write(std::span<const int>(reinterpret_cast<const int*>(images_.data()), 3 * number), 3);
    auto extra_vectors = static_cast<std::uint64_t>(registered_.size());
    if (writes) {
        a(extra_vectors);
    }
    for (Registered& extra : registered_) {
        if (writes) {
            a(extra.name);
        }
        vectors(extra.data);
    }
    if (writes) {
        a(forces_current_, phase_, time, step, bath);
    }
}

void State::read(Archive& a, SharedArchive& atoms) {
    const auto refuse_unless = [](bool sound, const char* what) {
        if (!sound) {
            throw CheckpointError(what);
        }
    };
    a.mark("state");
    Index total = 0;
    bool bounded = false;
    Vec3 edges = Vec3::Zero();
    a(total, bounded, edges);
    refuse_unless(total == total_, "it has another number of atoms");
    refuse_unless(bounded == box_.has_value(), "it is a fluid and the run one of a few bodies, or the other way round");
    refuse_unless(!bounded || edges == box_->edges(), "its box differs from that of the run");
    const auto vectors = [&](AlignedVector<double>& data) {
        atoms.read(data, vector_stride, [&](std::span<const double> piece) {
            refuse_unless(padding_is_zero(piece), "its atoms have a fourth coordinate");
        });
    };
    const auto anything = [](auto) {};
    AlignedVector<double> positions;
    vectors(positions);
    resize(static_cast<Index>(positions.size() / stride));
    std::copy(positions.begin(), positions.end(), positions_.begin());
    vectors(velocities_);
    vectors(forces_);
    atoms.read(masses_, 1, anything);
    std::vector<bool> seen(static_cast<std::size_t>(total_), false);
    atoms.read(ids_, 1, [&](std::span<const Index> piece) {
        for (const Index id : piece) {
            const bool new_one = id >= 0 && id < total_ && !seen[static_cast<std::size_t>(id)];
            refuse_unless(new_one, "its ids are not 0 to N - 1, each once");
            seen[static_cast<std::size_t>(id)] = true;
        }
    });
    constexpr int max_edges = 1 << 30;  // no run takes an atom so far, and further counting does not overflow
    std::vector<int> images;
    atoms.read(images, 3, [&](std::span<const int> piece) {
        refuse_unless(std::ranges::all_of(piece, [](int n) { return n > -max_edges && n < max_edges; }),
                      "an atom is too far from its box");
    });
    for (std::size_t i = 0; i < images_.size(); ++i) {
        images_[i] = Eigen::Vector3i(images[3 * i], images[3 * i + 1], images[3 * i + 2]);
    }
    registered_.clear();
    std::uint64_t extra_vectors = 0;
    a(extra_vectors);
    for (; extra_vectors > 0; --extra_vectors) {
        registered_.emplace_back();
        a(registered_.back().name);
        vectors(registered_.back().data);
    }
    a(forces_current_, phase_, time, step, bath);
    require_count(step);
    require_count(phase_.steps);
    ++order_version_;
}

std::vector<Index> State::index_of() const {
    if (!execution_.ranks().alone()) {
        throw ContractViolation("one rank of several does not have the atoms of all");
    }
    std::vector<Index> index(ids_.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        index[static_cast<std::size_t>(ids_[i])] = static_cast<Index>(i);
    }
    return index;
}

std::size_t State::register_vectors(const std::string& name) {
    for (std::size_t k = 0; k < registered_.size(); ++k) {
        if (registered_[k].name == name) {
            return k;
        }
    }
    registered_.push_back({name, AlignedVector<double>(stride * checked(count_))});
    return registered_.size() - 1;
}

VectorView State::registered(std::size_t handle) {
    return view(registered_.at(handle).data, 0, count_);
}
ConstVectorView State::registered(std::size_t handle) const {
    return view(registered_.at(handle).data, count_);
}

}  // namespace ljmd
