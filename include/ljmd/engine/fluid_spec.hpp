#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ljmd/detail/execution/simd.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/observables/statistics/run_averages.hpp"
#include "ljmd/detail/options/description.hpp"
#include "ljmd/detail/options/units.hpp"
#include "ljmd/detail/potentials/interaction.hpp"
#include "ljmd/engine/stage.hpp"
#include "ljmd/forces/external_force.hpp"
#include "ljmd/model/box.hpp"
#include "ljmd/model/configuration.hpp"
#include "ljmd/model/lattice.hpp"

namespace ljmd {

/// A box filled with a crystal. With a height it is a film: the crystal fills the lower part of the box.
struct LatticeStart {
    Lattice lattice = Lattice::fcc;
    Index cells = 6;                    ///< cubic cells along x and y, and along z; an fcc cell has 4 atoms
    std::optional<Index> layers = {};   ///< cubic cells along z instead
    std::optional<double> height = {};  ///< edge of the box along z [sigma], at least the crystal's

    [[nodiscard]] Index layers_along_z() const { return layers.value_or(cells); }
};

/// A cubic box with atoms at random places, which are pushed apart before the first step.
struct RandomStart {
    Index atoms = 864;
};

/// The fewest atoms of a tile that may be asked for: smaller ones are mostly ghosts.
inline constexpr Index min_tile = 50;

/// The longest skin that is allowed [sigma]: a longer list has all pairs, many times over in a small box.
inline constexpr double max_skin = 10.0;

/// The most atoms of a run: atoms and their images are indexed with 32 bits.
inline constexpr Index max_atoms = Index{1} << 30;

/// How pairs of atoms are found, see PairSearch in neighbors/pair_search.hpp.
struct NeighborSpec {
    std::string method = "verlet-list";  ///< one of pair_search_names()
    double skin = 0.3;                   ///< [sigma]
    std::optional<Index> every = {};     ///< steps between rebuilds of the list; none: when a pair could be missed
    std::optional<Index> tile = {};      ///< atoms of a tile, at most about; none: see ClusterGrid

    /// Whether the method keeps a list for several steps: only then do skin and every have a meaning.
    [[nodiscard]] bool keeps_list() const;

    void describe(Description& description);

    friend bool operator==(const NeighborSpec&, const NeighborSpec&) = default;
};

/// What a run of a fluid is, as plain values in reduced units: where the atoms are at the start, how they interact,
/// what is done with them, and what is measured.
///
/// What nobody says is Verlet's argon near its triple point: 864 atoms in an fcc crystal, Lennard-Jones cut at 2.5
/// sigma with tail corrections. Python's `Deck.fluid` has the same defaults; a deck has to say these.
struct FluidSpec {
    /// Where the atoms are at the start. A configuration brings its own box, and its velocities if it has any.
    std::variant<LatticeStart, RandomStart, Configuration> start = LatticeStart{};
    double density = 0.8442;                    ///< N/V of a random start; of the crystal of a lattice start [sigma^-3]
    std::optional<double> temperature = 0.722;  ///< of drawn velocities [epsilon/k_B]; stages may have their own
    bool keep_velocities = true;                ///< a configuration's, if it has any; else all are drawn
    std::uint64_t seed = 1;                     ///< of all random numbers, but for stages with a seed of their own

    PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    /// Whether energy and pressure are corrected for what the truncation removes, with g(r) = 1; none: where
    /// PairPotential::takes_tail(). Only such a truncation can be.
    std::optional<bool> tail = {};
    NeighborSpec neighbors = {};
    std::shared_ptr<ExternalForce> external = {};  ///< acts on the atoms beside the pair forces; null: none

    std::vector<Stage> stages = {};  ///< what is done, one after the other
    Index sample_every = 10;         ///< steps between samples of energy and pressure
    std::vector<Choice> analyses = {};

    /// For messages that also name a temperature in kelvin.
    std::optional<SubstanceUnits> units = {};

    [[nodiscard]] bool has_tail() const;

    /// The potential with its tail correction, if there is one.
    [[nodiscard]] Interaction interaction() const;
};

// These three throw InputError where there is no crystal, no box or no stage, see mistakes().

/// Number of atoms at the start.
[[nodiscard]] Index atoms_of(const FluidSpec& spec);

/// Box of a lattice start, at the density of its crystal [sigma^-3].
[[nodiscard]] Box lattice_box(const LatticeStart& start, double density);

/// Box at the start. An edge that is twice the cutoff but for rounding is made twice the cutoff, see box_for_cutoff.
[[nodiscard]] Box box_of(const FluidSpec& spec);

/// The stages with all that they leave to the rest of the specification or to defaults: seed and temperature of the
/// start, options of plug-ins. @throws InputError for a plug-in or an option that is not known
[[nodiscard]] std::vector<Stage> resolved_stages(const FluidSpec& spec);

/// Whether the velocities at the start are its configuration's; else they are drawn.
[[nodiscard]] bool keeps_velocities(const FluidSpec& spec);

/// The run as analyses see it: the time step of the first sampled stage and the length of the longest one; of the last
/// stage if none is sampled. The interaction is not set.
[[nodiscard]] SampledRun sampled_run(const std::vector<Stage>& stages, std::uint64_t seed, Index atoms, const Box& box);

/// The ensemble of the samples of a run. Without a barostat, several sampled stages have none: their samples do not
/// fluctuate like samples of one.
/// @param external  there is an external force: fluctuations are not as in a homogeneous fluid, nor as in one whose
/// centre of mass rests
[[nodiscard]] Ensemble sampled_ensemble(const std::vector<Stage>& stages, bool external = false);

/// The slowest thermostat and barostat of the sampled stages, see ThermostatOptions and BarostatOptions.
/// @param sample_every  steps between samples
[[nodiscard]] Baths sampled_baths(const std::vector<Stage>& stages, Index sample_every);

/// Whether a stage of a fluid conserves its total energy minus the heat from the thermostat: as
/// conserves_energy(stage), unless there is an external force without an energy.
[[nodiscard]] bool conserves_energy(const Stage& stage, const ExternalForce* external);

/// Why a fluid cannot be run, one sentence for each mistake, beginning with where it is ("stage 'production': ...").
/// Empty if it can.
[[nodiscard]] std::vector<std::string> mistakes(const FluidSpec& spec,
                                                Precision precision = Precision::double_precision);

/// @throws InputError with all mistakes(), one a line, if there are any
void require_no_mistakes(const FluidSpec& spec, Precision precision = Precision::double_precision);

}  // namespace ljmd
