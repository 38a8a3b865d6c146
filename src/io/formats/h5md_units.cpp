#include "io/formats/h5md_units.hpp"

#include <fmt/format.h>

#include "io/files/text_file.hpp"

namespace ljmd {

namespace {

/// A unit as H5MD files name it, "nm" or "Angstrom", in SI units; nothing if unknown.
std::optional<double> si_of(std::string name, Dimension dimension) {
    if (name == "Angstrom") {
        name = "angstrom";
    } else if (name == "g mol-1") {
        name = "g/mol";
    }
    return parse_quantity("1 " + name, dimension);
}

/// "nm ps-1" or "Angstrom/fs" in m/s.
std::optional<double> si_of_velocity(const std::string& name) {
    const std::size_t gap = name.find_first_of(" /");
    if (gap == std::string::npos) {
        return std::nullopt;
    }
    std::string per = name.substr(gap + 1);
    if (name[gap] == ' ') {
        if (!per.ends_with("-1")) {
            return std::nullopt;
        }
        per.resize(per.size() - 2);
    }
    const auto length = si_of(name.substr(0, gap), Dimension::length);
    const auto time = si_of(per, Dimension::time);
    return length && time ? std::optional(*length / *time) : std::nullopt;
}

std::optional<std::string> unit_of(const Hdf5Input& file, const std::string& dataset) {
    const std::vector<std::string> unit = file.text_attribute(dataset, "unit");
    return unit.empty() ? std::nullopt : std::optional(unit[0]);
}

/// One reduced unit in the unit of a dataset.
double scale_of(const Hdf5Input& file, const std::string& dataset, const std::string& unit, Dimension dimension,
                const std::optional<SubstanceUnits>& units) {
    const auto si = dimension == Dimension::velocity ? si_of_velocity(unit) : si_of(unit, dimension);
    if (!si) {
        file.fail(
            fmt::format("{} is in {}, which is no known unit of {}", dataset, shown(unit), dimension_name(dimension)));
    }
    if (!units) {
        file.fail(fmt::format("{} is in {}, which takes a substance: a deck with [argon] is needed (analyze: --deck)",
                              dataset, unit));
    }
    return units->si(dimension) / *si;
}

}  // namespace

H5mdScale h5md_scale(const Hdf5Input& file, const H5mdQuantities& quantities,
                     const std::optional<SubstanceUnits>& units) {
    H5mdScale scale;
    struct Quantity {
        const std::string& dataset;
        Dimension dimension;
        double& scale;
    };
    const bool has_units = unit_of(file, quantities.positions).has_value();
    for (const auto& [dataset, dimension, its_scale] :
         {Quantity{quantities.positions, Dimension::length, scale.length},
          Quantity{quantities.times, Dimension::time, scale.time},
          Quantity{quantities.velocities, Dimension::velocity, scale.velocity}}) {
        if (dataset.empty() || !file.exists(dataset)) {
            continue;
        }
        const std::optional<std::string> unit = unit_of(file, dataset);
        if (unit.has_value() != has_units) {
            file.fail(fmt::format("positions have {} unit, but {} has {}", has_units ? "a" : "no", dataset,
                                  has_units ? "none" : "one"));
        }
        if (unit) {
            its_scale = scale_of(file, dataset, *unit, dimension, units);
        }
    }
    const std::optional<std::string> unit = unit_of(file, quantities.edges);
    if (unit && !has_units) {
        file.fail(fmt::format("positions have no unit, but {} has one", quantities.edges));
    }
    scale.edges = unit ? scale_of(file, quantities.edges, *unit, Dimension::length, units) : scale.length;
    const auto mass_unit = file.exists(quantities.masses) ? unit_of(file, quantities.masses) : std::nullopt;
    if (mass_unit && !has_units) {
        file.fail(fmt::format("positions have no unit, but {} has one", quantities.masses));
    }
    if (has_units) {
        scale.mass = mass_unit ? std::optional(scale_of(file, quantities.masses, *mass_unit, Dimension::mass, units))
                               : std::nullopt;
    }
    return scale;
}

std::optional<double> h5md_force_scale(const Hdf5Input& file, const std::string& forces, const std::string& positions,
                                       const std::optional<SubstanceUnits>& units) {
    if (forces.empty()) {
        return std::nullopt;
    }
    const std::optional<std::string> unit = unit_of(file, forces);
    if (!unit && !unit_of(file, positions)) {
        return 1.0;
    }
    if (!units || (unit != "kJ mol-1 nm-1" && unit != "kJ/(mol nm)")) {
        return std::nullopt;
    }
    return units->kilojoule_per_mole() / units->nanometre();
}

}  // namespace ljmd
