#include "engine/tables/system_table.hpp"

#include <algorithm>

#include "engine/mistakes/film_mistakes.hpp"
#include "engine/mistakes/mistakes.hpp"

namespace ljmd {

namespace {

constexpr const char* of_file = "file";

std::string lattice_name(Lattice lattice) {
    const std::vector<std::string> names = lattice_names();
    return *std::ranges::find(names, lattice, find_lattice);
}

}  // namespace

void ArgonTable::describe(Description& description) {
    description.required_quantity("sigma", Dimension::length, sigma)
        .above(0.0)
        .meaning("Lennard-Jones length, e.g. \"3.405 angstrom\"");
    description.required_quantity("epsilon", Dimension::energy, epsilon)
        .above(0.0)
        .meaning("Lennard-Jones energy, e.g. \"119.8 K\" (times k_B)");
    description.required_quantity("mass", Dimension::mass, mass)
        .above(0.0)
        .meaning("mass of an atom, e.g. \"39.948 u\"");
}

void LatticeTable::describe(Description& description) {
    std::vector<std::string> types = lattice_names();
    types.emplace_back(random_places);
    description.required_choice("type", types, type)
        .meaning("where the atoms start; overlaps of a random start are relaxed before the first step");
    description.integer("cells", cells)
        .at_least(1)
        .at_most(static_cast<double>(max_cells))
        .optional("taken from `atoms`")
        .meaning("cubic cells along each edge: N = 4 cells^3 (fcc) or cells^3 (simple-cubic)");
    description.integer("atoms", atoms)
        .at_least(1)
        .at_most(1e9)
        .optional("taken from `cells`")
        .meaning("number of atoms instead of `cells`; required for random");
    description.integer("layers", layers)
        .at_least(1)
        .at_most(static_cast<double>(max_layers))
        .optional("`cells`")
        .meaning("cubic cells along z, for an elongated box: N = 4 cells^2 layers (fcc)");
    description.number("height", height)
        .dimension(Dimension::length)
        .unit("sigma")
        .above(0.0)
        .optional("that of the crystal")
        .meaning("edge of the box along z: a higher box holds a film, with empty space above and below");
}

bool LatticeTable::is_random() const {
    return type == random_places;
}

Lattice LatticeTable::crystal() const {
    return find_lattice(type);
}

LatticeStart LatticeTable::start() const {
    const Index along_edge = cells ? *cells : nearest_cells(crystal(), *atoms).below;
    return {crystal(), along_edge, layers, height};
}

void SystemTable::describe(TableDescription& description) {
    description.table("lattice", "lattice", lattice).optional("start from `file`").meaning("positions to start from");
    description.text("file", file)
        .optional("start from `lattice`")
        .meaning(
            "file to start from (extended XYZ, the last frame of an H5MD file or a LAMMPS dump, LAMMPS data or NIST "
            "configuration, recognised by content), or the directory of a finished run");
    description.text("xyz_comment", xyz_comment)
        .optional("the comment lines of `file` say all")
        .meaning("keys that the comment lines of an XYZ `file` lack: 'Lattice=\"20 0 0 0 20 0 0 0 20\" units=si'");
    description.number("density", density)
        .dimension(Dimension::density)
        .unit("sigma^-3")
        .at_least(min_density)
        .optional("that of `file`")
        .meaning(
            "number density N/V; of the crystal, where `lattice` has a `height`; with `file`, box and positions are "
            "scaled to it");
    description.number("temperature", temperature)
        .dimension(Dimension::temperature)
        .unit("epsilon/k_B")
        .at_least(0.0)
        .optional("from the velocities in `file`")
        .meaning("temperature of the start, and of thermostats");
    description.choice("velocities", {maxwell, of_file}, velocities)
        .optional("file if it has velocities, else maxwell")
        .meaning("draw velocities from Maxwell's distribution, or keep those of `file`");
    description.integer("seed", seed)
        .at_least(0)
        .meaning(
            "of all random numbers; a run that starts from the end of another one under a thermostat needs another "
            "seed");
}

bool SystemTable::draws_velocities() const {
    return velocities == maxwell;
}

bool SystemTable::wants_velocities_of_file() const {
    return velocities == of_file;
}

bool SystemTable::is_film() const {
    return lattice && density && !lattice->is_random() && ljmd::is_film(lattice->start(), *density);
}

std::variant<LatticeStart, RandomStart, Configuration> SystemTable::start() const {
    if (!lattice) {
        return Configuration{};
    }
    if (lattice->is_random()) {
        return RandomStart{*lattice->atoms};
    }
    return lattice->start();
}

SystemTable system_table(const FluidSpec& spec, const std::string& file) {
    SystemTable table;
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        LatticeTable& lattice = table.lattice.emplace();
        lattice.type = lattice_name(crystal->lattice);
        lattice.cells = crystal->cells;
        lattice.layers = crystal->layers;
        lattice.height = crystal->height;
        table.density = spec.density;
    } else if (const auto* random = std::get_if<RandomStart>(&spec.start)) {
        LatticeTable& lattice = table.lattice.emplace();
        lattice.type = LatticeTable::random_places;
        lattice.atoms = random->atoms;
        table.density = spec.density;
    } else {
        table.file = file;
        table.velocities = spec.keep_velocities ? std::nullopt : std::optional<std::string>(SystemTable::maxwell);
    }
    table.temperature = spec.temperature;
    table.seed = static_cast<Index>(spec.seed);
    return table;
}

}  // namespace ljmd
