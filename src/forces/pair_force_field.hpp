#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ljmd/detail/core/aligned_vector.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/execution/execution.hpp"
#include "ljmd/forces/external_force.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "neighbors/pair_search.hpp"
#include "neighbors/tile_positions.hpp"

namespace ljmd {

/// Pair forces in a periodic box: f_i = sum over j with r_ij < rc of w(r_ij) (r_i - r_j).
///
/// Forces are summed part by part of the search; threads share the parts. Energy and virial are added up part by part.
/// Both depend on nothing but the configuration and the order of sums that it decides.
///
/// With a Verlet list, kernels of the SIMD level compute the sum in either precision. With the other searches, for
/// order-independent forces, and for custom potentials, scalar code computes it in double (see sum_pairs).
///
/// An external force, if there is one, is added to the sum.
class PairForceField : public ForceField {
  public:
    /// @pre potential.cutoff().radius <= L/2 for every box that will be evaluated (checked: ContractViolation)
    /// @param execution  SIMD level and precision of the sum; the threads are taken from the state that is evaluated
    /// @throws ContractViolation for mixed precision without a Verlet list, or of a custom potential
    PairForceField(PairPotential potential, PairSearch search, const Execution& execution = {});

    [[nodiscard]] const PairPotential& potential() const { return potential_; }
    [[nodiscard]] const PairSearch& search() const { return search_; }
    [[nodiscard]] SimdLevel simd() const { return simd_; }
    [[nodiscard]] Precision precision() const { return precision_; }
    [[nodiscard]] const SearchStatistics& search_statistics() const;
    /// The external force; null: none. Set it before the evaluation that it is to be in.
    void set_external(std::shared_ptr<ExternalForce> force);
    [[nodiscard]] std::shared_ptr<ExternalForce> external() const { return external_ ? external_->force() : nullptr; }
    /// Whether the external force of the last evaluation differs between atoms.
    [[nodiscard]] bool external_differs() const { return external_ && external_->differs(); }
    /// Wall time spent on pair sums and on the external force, without the neighbour search [s].
    [[nodiscard]] double seconds_summing() const { return seconds_summing_; }

    void archive(Archive& a, State& state) override;

  private:
    Evaluation compute(State& state, Request request) override;

    /// The list, if a kernel computes what is requested; else null.
    [[nodiscard]] VerletList* list_for_kernel(Request request);
    [[nodiscard]] Evaluation sum(State& state, Request request);
    [[nodiscard]] Evaluation sum_by_kernel(VerletList& list, State& state, bool energy);
    void add_ghost_forces(const VerletList& list, State& state) const;

    /// Arrays of a thread for the tile that it works on, so that they stay in the cache next to a core.
    struct Workspace {
        TilePositions<double> positions;
        TilePositions<std::int32_t> fixed_positions;  ///< for mixed precision
        AlignedVector<double> partial_forces;
    };

    PairPotential potential_;
    PairSearch search_;
    SimdLevel simd_;
    Precision precision_;
    std::optional<ExternalForceTerm> external_;
    std::vector<Workspace> workspaces_;
    std::vector<AlignedVector<double>> ghost_forces_;  ///< forces on each tile's ghost clusters
    double seconds_summing_ = 0.0;
};

}  // namespace ljmd
