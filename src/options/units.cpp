#include "ljmd/detail/options/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "ljmd/core/errors.hpp"

namespace ljmd {
namespace {

// CODATA 2018.
constexpr double boltzmann = 1.380649e-23;         // [J/K], exact
constexpr double avogadro = 6.02214076e23;         // [1/mol], exact
constexpr double electron_volt = 1.602176634e-19;  // [J], exact
constexpr double atomic_mass = 1.66053906660e-27;  // [kg]

constexpr double longest_wall_time = 1e9;  // [s], 32 years

struct Unit {
    Dimension dimension;
    std::string_view name;
    double si;
    bool listed;  // false: another spelling of a listed unit
};

// In the order of messages.
constexpr Unit units[] = {
    {Dimension::length, "angstrom", 1e-10, true},
    {Dimension::length, "nm", 1e-9, true},
    {Dimension::length, "pm", 1e-12, true},
    {Dimension::length, "m", 1.0, true},
    {Dimension::length, "A", 1e-10, false},
    {Dimension::length, "\u00C5", 1e-10, false},  // letter A with ring
    {Dimension::length, "\u212B", 1e-10, false},  // angstrom sign
    {Dimension::energy, "K", boltzmann, true},
    {Dimension::energy, "kJ/mol", 1e3 / avogadro, true},
    {Dimension::energy, "kcal/mol", 4184.0 / avogadro, true},
    {Dimension::energy, "eV", electron_volt, true},
    {Dimension::energy, "J", 1.0, true},
    {Dimension::temperature, "K", 1.0, true},
    {Dimension::mass, "u", atomic_mass, true},
    {Dimension::mass, "amu", atomic_mass, false},
    {Dimension::mass, "Da", atomic_mass, false},
    {Dimension::mass, "g/mol", 1e-3 / avogadro, true},
    {Dimension::mass, "kg", 1.0, true},
    {Dimension::time, "ps", 1e-12, true},
    {Dimension::time, "fs", 1e-15, true},
    {Dimension::time, "ns", 1e-9, true},
    {Dimension::time, "s", 1.0, true},
    {Dimension::density, "g/cm3", 1e3, true},
    {Dimension::density, "kg/m3", 1.0, true},
    {Dimension::pressure, "bar", 1e5, true},
    {Dimension::pressure, "MPa", 1e6, true},
    {Dimension::pressure, "kPa", 1e3, true},
    {Dimension::pressure, "Pa", 1.0, true},
    {Dimension::pressure, "atm", 101325.0, true},
    {Dimension::velocity, "nm/ps", 1e3, true},
    {Dimension::velocity, "angstrom/ps", 1e2, true},
    {Dimension::velocity, "m/s", 1.0, true},
};

struct NumberAndUnit {
    double number;
    std::string_view unit;
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<NumberAndUnit> split(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return NumberAndUnit{number, trimmed(text)};
}

}  // namespace

std::optional<double> parse_quantity(const std::string& text, Dimension dimension) {
    const auto parts = split(text);
    if (!parts) return std::nullopt;
    for (const Unit& unit : units) {
        if (unit.dimension != dimension || unit.name != parts->unit) continue;
        const double value = parts->number * unit.si;
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
    return std::nullopt;
}

std::string quantity_text(double si, Dimension dimension) {
    const auto* const unit = std::ranges::find_if(
        units, [dimension](const Unit& one) { return one.dimension == dimension && one.si == 1.0; });
    return fmt::format("{} {}", si, unit->name);
}

std::optional<std::string> unit_of(const std::string& text) {
    const auto parts = split(text);
    return parts ? std::optional<std::string>(parts->unit) : std::nullopt;
}

std::optional<double> parse_wall_time(const std::string& text) {
    constexpr std::pair<std::string_view, double> names[] = {{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}};
    const auto parts = split(text);
    for (const auto& [name, seconds] : names) {
        if (parts && parts->unit == name && parts->number > 0.0 && parts->number * seconds <= longest_wall_time) {
            return parts->number * seconds;
        }
    }
    return std::nullopt;
}

std::string dimension_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::length:
            return "length";
        case Dimension::energy:
            return "energy";
        case Dimension::temperature:
            return "temperature";
        case Dimension::mass:
            return "mass";
        case Dimension::time:
            return "time";
        case Dimension::density:
            return "density";
        case Dimension::pressure:
            return "pressure";
        case Dimension::velocity:
            return "velocity";
        case Dimension::none:
            break;
    }
    return "no dimension";
}

std::string unit_names(Dimension dimension) {
    std::vector<std::string_view> names;
    for (const Unit& unit : units) {
        if (unit.dimension == dimension && unit.listed) names.push_back(unit.name);
    }
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return text;
}

SubstanceUnits::SubstanceUnits(double sigma, double epsilon, double mass)
    : sigma_(sigma), epsilon_(epsilon), mass_(mass) {
    for (const double value : {sigma, epsilon, mass}) {
        if (!std::isfinite(value) || value <= 0.0) {
            throw InputError(
                fmt::format("sigma, epsilon and mass of a substance are finite and above 0, found {}", value));
        }
    }
}

double SubstanceUnits::si(Dimension dimension) const {
    const double volume = sigma_ * sigma_ * sigma_;
    switch (dimension) {
        case Dimension::length:
            return sigma_;
        case Dimension::energy:
            return epsilon_;
        case Dimension::temperature:
            return epsilon_ / boltzmann;
        case Dimension::mass:
            return mass_;
        case Dimension::time:
            return sigma_ * std::sqrt(mass_ / epsilon_);
        case Dimension::density:
            return mass_ / volume;
        case Dimension::pressure:
            return epsilon_ / volume;
        case Dimension::velocity:
            return std::sqrt(epsilon_ / mass_);
        case Dimension::none:
            break;
    }
    return 1.0;
}

double SubstanceUnits::kelvin() const {
    return si(Dimension::temperature);
}
double SubstanceUnits::bar() const {
    return si(Dimension::pressure) / 1e5;
}
double SubstanceUnits::kilojoule_per_mole() const {
    return epsilon_ * avogadro / 1e3;
}
double SubstanceUnits::gram_per_cm3() const {
    return si(Dimension::density) / 1e3;
}
double SubstanceUnits::picosecond() const {
    return si(Dimension::time) / 1e-12;
}
double SubstanceUnits::nanometre() const {
    return sigma_ / 1e-9;
}
double SubstanceUnits::dalton() const {
    return mass_ / atomic_mass;
}

}  // namespace ljmd
