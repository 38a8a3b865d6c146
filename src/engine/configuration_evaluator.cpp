#include "ljmd/engine/configuration_evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/mistakes/mistakes.hpp"
#include "forces/atom_energies.hpp"
#include "forces/pair_force_field.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/box_for_cutoff.hpp"
#include "neighbors/pair_search.hpp"
#include "observables/pairs_too_near.hpp"

namespace ljmd {

namespace {

using Positions = Eigen::Ref<const Eigen::Matrix3Xd>;

constexpr double max_crossings = 1e6;  // of one position, see State::wrap()

void require_none(const std::vector<Mistake>& mistakes) {
    if (!mistakes.empty()) {
        throw InputError(in_words(mistakes.front()));
    }
}

void require_sound(const Positions& positions, const Vec3& edges) {
    if (positions.cols() < 1 || positions.cols() > max_atoms) {
        throw InputError(fmt::format("positions: {} atoms: allowed are 1 to {}", positions.cols(), max_atoms));
    }
    for (Index i = 0; i < positions.cols(); ++i) {
        if (!positions.col(i).allFinite()) {
            throw InputError(fmt::format("positions: that of atom {}, counted from 0, is not finite", i));
        }
    }
    if (!(edges.allFinite() && edges.minCoeff() > 0.0)) {
        throw InputError(fmt::format("edges: ({}, {}, {}): those of a box are above 0", edges[0], edges[1], edges[2]));
    }
}

/// @throws InputError for forces, energy or virial that are not finite, naming the atoms that are nearest to each other
void require_finite(const State& state, const Evaluation& evaluation, double cutoff) {
    if (std::isfinite(evaluation.potential_energy) && evaluation.virial.allFinite() && state.forces().allFinite()) {
        return;
    }
    const NearPairs pairs = pairs_nearer_than(state, cutoff);
    throw InputError(
        fmt::format("positions: atoms {} and {}, counted from 0, are {:.3g} apart: they overlap, the forces between "
                    "them are not finite",
                    std::min(pairs.first, pairs.second), std::max(pairs.first, pairs.second), pairs.nearest));
}

/// A position in the box, on its grid.
Vec3 placed(const Box& box, const Vec3& r, Index atom) {
    const Vec3 n = box.crossings(r);
    if (!(n.cwiseAbs().maxCoeff() < max_crossings)) {
        throw InputError(
            fmt::format("positions: atom {}, counted from 0, is more than a million edges away from the box", atom));
    }
    return box.snap(r - n.cwiseProduct(box.edges()));
}

}  // namespace

/// Atoms and neighbour list, which belong together.
struct ConfigurationEvaluator::Parts {
    State state;
    PairForceField force_field;
    Vec3 edges;  ///< that were asked for
};

ConfigurationEvaluator::ConfigurationEvaluator(const PairPotential& potential, bool tail, const NeighborSpec& neighbors,
                                               const Execution& execution)
    : interaction_{potential, TailCorrection()}, neighbors_(neighbors), execution_(execution) {
    require_none(potential_mistakes(potential.truncation(), potential.cutoff(), tail));
    require_none(search_mistakes(neighbors, execution.precision()));
    if (tail) {
        interaction_.tail = TailCorrection(potential);
    }
}

ConfigurationEvaluator::~ConfigurationEvaluator() = default;
ConfigurationEvaluator::ConfigurationEvaluator(ConfigurationEvaluator&&) noexcept = default;
ConfigurationEvaluator& ConfigurationEvaluator::operator=(ConfigurationEvaluator&&) noexcept = default;

EvaluatedConfiguration ConfigurationEvaluator::evaluate(const Positions& positions, const Vec3& edges) {
    require_sound(positions, edges);
    if (!parts_ || parts_->state.count() != positions.cols() || parts_->edges != edges || !move_to(positions)) {
        begin(positions, edges);
    }
    State& state = parts_->state;
    const Evaluation evaluation = parts_->force_field.evaluate(state, Request::forces_and_energy);
    require_finite(state, evaluation, interaction_.potential.cutoff().radius);
    const auto atoms = static_cast<double>(state.count());
    EvaluatedConfiguration result;
    result.potential_energy =
        evaluation.potential_energy / atoms + interaction_.tail.energy(atoms / state.box().volume());
    result.virial = evaluation.virial;
    result.virial_pressure = virial_pressure(state, evaluation, interaction_.tail);
    result.too_near = pairs_too_near(state, interaction_.potential);
    result.forces.resize(3, state.count());
    const auto forces = state.forces();
    for (Index i = 0; i < state.count(); ++i) {
        result.forces.col(state.ids()[static_cast<std::size_t>(i)]) = forces.col(i);
    }
    return result;
}

std::vector<double> ConfigurationEvaluator::atom_energies() const {
    if (!parts_) {
        throw InputError("energies of atoms: no configuration was evaluated yet");
    }
    return ljmd::atom_energies(parts_->state, interaction_.potential);
}

/// New atoms and a new list.
void ConfigurationEvaluator::begin(const Positions& positions, const Vec3& edges) {
    parts_.reset();
    const Box box = box_for_cutoff(Box(edges), interaction_.potential.cutoff().radius);
    require_none(cutoff_mistakes(interaction_.potential.cutoff().radius, box));
    State state(positions.cols(), box, execution_);
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        r.col(i) = placed(box, positions.col(i), i);
    }
    state.wrap();  // rounding to the grid may have put an atom onto the far wall
    parts_ = std::make_unique<Parts>(
        Parts{std::move(state),
              PairForceField(interaction_.potential,
                             make_pair_search(neighbors_.method, neighbors_.skin, neighbors_.every, neighbors_.tile),
                             execution_),
              edges});
}

/// Move each atom to the image of its new position that is nearest to where it is. @return false where that is too
/// far away, or the image too far outside the box for its grid: the atoms are then to be placed anew
bool ConfigurationEvaluator::move_to(const Positions& positions) {
    const Box& box = parts_->state.box();
    const Vec3 lowest = -0.25 * box.edges();
    const Vec3 highest = 1.05 * box.edges();
    const std::vector<Index>& ids = parts_->state.ids();
    auto r = parts_->state.write_positions();
    for (Index i = 0; i < r.cols(); ++i) {
        const Vec3 wanted = positions.col(ids[static_cast<std::size_t>(i)]);
        const Vec3 edges_away = (wanted - r.col(i)).cwiseQuotient(box.edges()).array().round();
        const Vec3 nearest = wanted - edges_away.cwiseProduct(box.edges());
        if (!(edges_away.cwiseAbs().maxCoeff() < max_crossings && (nearest.array() > lowest.array()).all() &&
              (nearest.array() < highest.array()).all())) {
            return false;
        }
        r.col(i) = box.snap(nearest);
    }
    return true;
}

}  // namespace ljmd
