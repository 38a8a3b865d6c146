#include "engine/mistakes/film_mistakes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/mistakes/keys_of_mistakes.hpp"
namespace ljmd {

namespace {

double height_of_crystal(const LatticeStart& lattice, double density) {
    return crystal_edges(lattice.lattice, lattice.cells, lattice.layers_along_z(), density).z();
}

}  // namespace

bool is_film(const LatticeStart& lattice, double density) {
    constexpr double rounding = 1e-9;
    return lattice.height && *lattice.height > (1.0 + rounding) * height_of_crystal(lattice, density);
}

bool is_film(const FluidSpec& spec) {
    const auto* crystal = std::get_if<LatticeStart>(&spec.start);
    return crystal != nullptr && is_film(*crystal, spec.density);
}

std::vector<Mistake> film_mistakes(const LatticeStart& lattice, double density, bool tail) {
    std::vector<Mistake> found;
    if (!lattice.height) {
        return found;
    }
    const double crystal = height_of_crystal(lattice, density);
    if (!(*lattice.height >= crystal && std::isfinite(*lattice.height))) {
        found.push_back({"system",
                         "",
                         0,
                         fmt::format("is {}, but the crystal is {:.6g} sigma high", *lattice.height, crystal),
                         true,
                         {lattice_key(&LatticeTable::height), lattice_key(&LatticeTable::cells),
                          lattice_key(&LatticeTable::layers), key(&SystemTable::density)},
                         ""});
    }
    if (tail) {
        found.push_back({"potential",
                         "",
                         0,
                         "a film is not homogeneous, as the tail correction takes for granted: use a shifted form, or "
                         "tail = false",
                         false,
                         {potential_key(&PotentialTable::tail)},
                         ""});
    }
    return found;
}

std::vector<Mistake> homogeneity_mistakes(const std::vector<Choice>& analyses, bool is_film) {
    std::vector<Mistake> found;
    for (const Choice& each : analyses) {
        if (find_analysis(each.name).needs.homogeneous && is_film) {
            found.push_back({"system",
                             "",
                             0,
                             fmt::format("the analysis {} is for a homogeneous fluid, and a box that is higher than "
                                         "its crystal holds a film",
                                         each.name),
                             false,
                             {lattice_key(&LatticeTable::height)},
                             "leave one of the two out"});
        }
    }
    return found;
}

}  // namespace ljmd
