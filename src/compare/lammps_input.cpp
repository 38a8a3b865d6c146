#include "compare/lammps_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// A potential of ljmd and its LAMMPS pair style.
struct PairStyle {
    std::string_view formula;
    std::string_view truncation;
    std::string_view style;
    std::string_view modify;  ///< the options of pair_modify
    bool tail = false;        ///< LAMMPS has tail corrections for it
};
constexpr std::array pair_styles{
    PairStyle{"lennard-jones", "cut", "lj/cut", "shift no tail no", true},
    PairStyle{"lennard-jones", "shifted", "lj/cut", "shift yes tail no"},
    PairStyle{"lennard-jones", "force-shifted", "lj/smooth/linear", ""},
    PairStyle{"lennard-jones", "switched", "lj/mdf", ""},
    PairStyle{"morse", "cut", "morse", "shift no"},
    PairStyle{"morse", "shifted", "morse", "shift yes"},
    PairStyle{"morse", "force-shifted", "morse/smooth/linear", ""},
};

const PairStyle& pair_style_of(const PairPotential& potential) {
    std::vector<std::string> names;
    for (const PairStyle& style : pair_styles) {
        if (style.formula == potential.formula() && style.truncation == potential.truncation()) {
            return style;
        }
        names.push_back(fmt::format("{} {}", style.formula, style.truncation));
    }
    throw InputError(fmt::format("LAMMPS has no potential '{}' with truncation '{}'; it has: {}", potential.formula(),
                                 potential.truncation(), fmt::join(names, ", ")));
}

double parameter(const PairPotential& potential, std::string_view key) {
    for (const auto& [name, value] : potential.parameters()) {
        if (name == key) {
            return value;
        }
    }
    throw ContractViolation(fmt::format("the potential '{}' has no parameter '{}'", potential.formula(), key));
}

/// Arguments of pair_coeff after the atom types.
std::string coefficients(const PairPotential& potential) {
    return potential.formula() == "morse"
               ? fmt::format("{} {} {}", parameter(potential, "well_depth"), parameter(potential, "steepness"),
                             parameter(potential, "minimum"))
               : "1.0 1.0";  // epsilon and sigma
}

/// Units, atoms, forces and neighbour lists.
std::string system_lines(const Fluid& fluid) {
    return fmt::format(
        "units lj\n"
        "atom_style atomic\n"
        "read_data {}\n"
        "{}"
        "neighbor 0.3 bin\n"
        "neigh_modify every 1 delay 0 check yes\n",
        LammpsFiles::start, lammps_pair_style(fluid.potential));
}

/// The same with the columns of the tables. The kinetic energy is not thermo_style's, which is computed from the
/// temperature and vanishes for a single atom.
std::string table_lines(const Fluid& fluid) {
    return system_lines(fluid) +
           "compute kinetic all ke\n"
           "compute virial all pressure NULL virial\n"
           "thermo_style custom step pe c_kinetic c_virial\n"
           "thermo_modify norm no format float %.17g\n"
           "fix integrate all nve\n";
}

std::string frame_line() {
    return fmt::format("write_dump all custom {} id xu yu zu modify sort id format float %.17g append yes\n",
                       LammpsFiles::frames);
}

/// A title that is safe in a LAMMPS comment: an `&` at its end would hide the next line, and quotes may open a
/// multi-line text.
std::string harmless(std::string title) {
    constexpr std::string_view allowed = " ()+,-./0123456789:=ABCDEFGHIJKLMNOPQRSTUVWXYZ_abcdefghijklmnopqrstuvwxyz";
    std::replace_if(
        title.begin(), title.end(), [&](char c) { return allowed.find(c) == std::string_view::npos; }, '_');
    return title;
}

void append_vector(std::string& text, std::size_t id, std::string_view between, const Vec3& v) {
    fmt::format_to(std::back_inserter(text), "{} {}{} {} {}\n", id, between, v[0], v[1], v[2]);
}

}  // namespace

std::string lammps_data(const Fluid& fluid) {
    const std::size_t count = fluid.positions.size();
    std::vector<double> masses;  // of the atom types
    std::vector<std::size_t> types(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto known = std::find(masses.begin(), masses.end(), fluid.masses[i]);
        types[i] = static_cast<std::size_t>(known - masses.begin()) + 1;
        if (known == masses.end()) {
            masses.push_back(fluid.masses[i]);
        }
    }
    std::string text = fmt::format(
        "LAMMPS data file by ljmd, units = lj\n\n{} atoms\n{} atom types\n\n"
        "0.0 {} xlo xhi\n0.0 {} ylo yhi\n0.0 {} zlo zhi\n\nMasses\n\n",
        count, masses.size(), fluid.edges[0], fluid.edges[1], fluid.edges[2]);
    for (std::size_t type = 0; type < masses.size(); ++type) {
        fmt::format_to(std::back_inserter(text), "{} {}\n", type + 1, masses[type]);
    }
    text += "\nAtoms # atomic\n\n";
    for (std::size_t i = 0; i < count; ++i) {
        append_vector(text, i + 1, fmt::format("{} ", types[i]), fluid.positions[i]);
    }
    text += "\nVelocities\n\n";
    for (std::size_t i = 0; i < count; ++i) {
        append_vector(text, i + 1, "", fluid.velocities[i]);
    }
    return text;
}

std::string lammps_pair_style(const PairPotential& potential) {
    const PairStyle& style = pair_style_of(potential);
    const Cutoff& cutoff = potential.cutoff();
    std::string text = fmt::format("pair_style {} ", style.style);
    text += PairPotential::takes_switch_start(potential.truncation())
                ? fmt::format("{} {}\n", cutoff.switch_start, cutoff.radius)
                : fmt::format("{}\n", cutoff.radius);
    text += fmt::format("pair_coeff * * {}\n", coefficients(potential));
    if (!style.modify.empty()) {
        text += fmt::format("pair_modify {}\n", style.modify);
    }
    return text;
}

bool lammps_has_tail(const PairPotential& potential) {
    return pair_style_of(potential).tail;
}

std::string lammps_point_input(const Fluid& fluid) {
    std::string text = table_lines(fluid) + "run 0\n";
    text +=
        fmt::format("write_dump all custom {} id fx fy fz modify sort id format float %.17g\n", LammpsFiles::forces);
    if (fluid.tail && lammps_has_tail(fluid.potential)) {
        text += "pair_modify tail yes\nrun 0\n";
    }
    return text;
}

std::string lammps_follow_input(const Fluid& fluid, double time_step, const std::vector<Index>& steps) {
    std::string text = table_lines(fluid) + fmt::format("timestep {}\nthermo 0\nrun 0 post no\n", time_step);
    Index step = 0;
    for (const Index wanted : steps) {
        // With "pre no" a run continues as if there had been no break.
        if (wanted > step) {
            text += fmt::format("run {} pre no post no\n", wanted - step);
        }
        text += frame_line();
        step = wanted;
    }
    return text;
}

std::string lammps_sample_input(const Fluid& fluid, double time_step, Index steps, Index every, Index frame_every) {
    std::string text = table_lines(fluid) + fmt::format("timestep {}\nthermo {}\n", time_step, every);
    if (frame_every > 0) {
        text += fmt::format("dump frames all custom {} {} id xu yu zu\n", frame_every, LammpsFiles::frames) +
                "dump_modify frames sort id format float %.17g\n";
    }
    return text + fmt::format("run {}\n", steps);
}

std::string lammps_user_input(const Fluid& fluid, double time_step, Index steps, const std::string& title) {
    std::string text = fmt::format("# {}\n# Made by ljmd; the atoms are in {}. Energies are per atom.\n",
                                   harmless(title), LammpsFiles::start);
    text += system_lines(fluid);
    if (fluid.tail) {
        text +=
            lammps_has_tail(fluid.potential)
                ? "pair_modify tail yes\n"
                : "# Tail corrections are wanted, but LAMMPS has none for this pair style: pe and press are without.\n";
    }
    text += fmt::format(
        "# By LAMMPS' convention press is (2 K + W)/(3 V). With rho T in place of the motion of 3 N - 3 degrees of "
        "freedom,\n"
        "# as ljmd has the pressure, it is larger by T/V: v_p.\n"
        "variable p equal press+temp/vol\n"
        "thermo_style custom step time temp pe ke etotal press v_p\n"
        "thermo_modify norm yes format float %.17g\n"
        "fix integrate all nve\n"
        "timestep {}\n"
        "run 0\n\n"
        "variable steps index {}\n"
        "thermo 100\n"
        "run ${{steps}}\n"
        "write_dump all custom final.lammpsdump id type xu yu zu vx vy vz modify sort id format float %.17g\n",
        time_step, steps);
    return text;
}

}  // namespace ljmd
