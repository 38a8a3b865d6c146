#pragma once

#include <optional>
#include <string>
#include <variant>

#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/model/lattice.hpp"
#include "options/placed.hpp"

namespace ljmd {

// The tables of a deck that make a FluidSpec, and that one makes.

/// [argon]: a real substance.
struct ArgonTable {
    double sigma = 0.0;    ///< [m]
    double epsilon = 0.0;  ///< [J]
    double mass = 0.0;     ///< [kg]

    void describe(Description& description);
};

/// `lattice` in [system]: positions to start from.
struct LatticeTable {
    static constexpr const char* random_places = "random";  ///< in place of a lattice

    std::string type;
    std::optional<Index> cells;  ///< along an edge
    std::optional<Index> atoms;
    std::optional<Index> layers;   ///< cells along z
    std::optional<double> height;  ///< of the box [sigma]

    void describe(Description& description);

    [[nodiscard]] bool is_random() const;
    [[nodiscard]] Lattice crystal() const;     ///< @pre !is_random()
    [[nodiscard]] LatticeStart start() const;  ///< @pre !is_random(), and cells or atoms are given
};

/// [system]: atoms and box at the start.
struct SystemTable {
    static constexpr const char* maxwell = "maxwell";  ///< velocities that are drawn

    std::optional<Placed<LatticeTable>> lattice;
    std::optional<std::string> file;
    std::optional<std::string> xyz_comment;
    std::optional<double> density;      ///< [sigma^-3]
    std::optional<double> temperature;  ///< [epsilon/k_B]
    std::optional<std::string> velocities;
    Index seed = static_cast<Index>(FluidSpec().seed);

    void describe(TableDescription& description);

    /// Whether the deck asks for velocities from Maxwell's distribution, or for the file's; it may ask for neither.
    [[nodiscard]] bool draws_velocities() const;
    [[nodiscard]] bool wants_velocities_of_file() const;

    [[nodiscard]] bool is_film() const;  ///< see is_film() of a FluidSpec

    /// Where the atoms are at the start; an empty configuration for a file, which is not read here.
    [[nodiscard]] std::variant<LatticeStart, RandomStart, Configuration> start() const;
};

/// The table of a specification. @param file  where a configuration to start from can be read
[[nodiscard]] SystemTable system_table(const FluidSpec& spec, const std::string& file);

}  // namespace ljmd
