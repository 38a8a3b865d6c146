#pragma once

#include <optional>
#include <string>

namespace ljmd {

/// Physical dimensions of values that decks can give with a unit.
enum class Dimension { none, length, energy, temperature, mass, time, density, pressure, velocity };

/// Convert a number with a unit, "3.405 angstrom", to SI.
/// Energies may be given as temperatures: "119.8 K" is 119.8 k_B.
///
/// Units known: length m, nm, angstrom (also "A", "Å"), pm; energy J, kJ/mol, kcal/mol, eV, K; temperature K;
/// mass kg, g/mol, u (also "amu", "Da"); time s, ns, ps, fs; density kg/m3, g/cm3; pressure Pa, kPa, MPa, bar, atm;
/// velocity m/s, nm/ps, angstrom/ps.
///
/// @return the value in m, J, K, kg, s, kg/m^3, Pa or m/s; empty if the text is no finite number with a unit of that
/// dimension
[[nodiscard]] std::optional<double> parse_quantity(const std::string& text, Dimension dimension);

/// A quantity in SI as a text that parse_quantity() reads to the same value: "3.405e-10 m".
/// @pre the dimension is not none
[[nodiscard]] std::string quantity_text(double si, Dimension dimension);

/// The unit, known or not, of a text that begins with a finite number: "K" for "86.5 K", "" for "86.5". Empty if the
/// text does not begin with a finite number.
[[nodiscard]] std::optional<std::string> unit_of(const std::string& text);

/// Parse a wall time: a positive number with s, min, h or d, as "90 s" or "2h".
/// @return seconds; empty if the text is no wall time, or one above 1e9 s
[[nodiscard]] std::optional<double> parse_wall_time(const std::string& text);

/// Name of a dimension for messages: "length", "temperature", ...
[[nodiscard]] std::string dimension_name(Dimension dimension);

/// Accepted units of a dimension for messages: "angstrom, nm, pm or m".
[[nodiscard]] std::string unit_names(Dimension dimension);

/// Lennard-Jones units of a real substance: conversion between reduced units and SI.
///
/// In reduced units sigma = epsilon = m = k_B = 1; the unit of time is tau = sqrt(m sigma^2 / epsilon).
/// Constants: CODATA 2018 (k_B and N_A exact).
class SubstanceUnits {
  public:
    /// @param sigma   length [m]
    /// @param epsilon energy [J]
    /// @param mass    mass of one atom [kg]
    /// @throws InputError unless all are finite and positive
    SubstanceUnits(double sigma, double epsilon, double mass);

    /// SI value of one reduced unit of a dimension: sigma, epsilon, epsilon/k_B, m, tau, m/sigma^3, epsilon/sigma^3,
    /// sigma/tau. 1 for Dimension::none.
    [[nodiscard]] double si(Dimension dimension) const;

    /// Reduced value of an SI quantity.
    [[nodiscard]] double reduced(double quantity, Dimension dimension) const { return quantity / si(dimension); }

    // One reduced unit in the units usual for argon.
    [[nodiscard]] double kelvin() const;              ///< temperature
    [[nodiscard]] double bar() const;                 ///< pressure
    [[nodiscard]] double kilojoule_per_mole() const;  ///< energy
    [[nodiscard]] double gram_per_cm3() const;        ///< density
    [[nodiscard]] double picosecond() const;          ///< time
    [[nodiscard]] double nanometre() const;           ///< length
    [[nodiscard]] double dalton() const;              ///< mass

  private:
    double sigma_;
    double epsilon_;
    double mass_;
};

}  // namespace ljmd
