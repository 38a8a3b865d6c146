#pragma once

#include <vector>

#include "engine/mistakes/mistakes.hpp"

namespace ljmd {

/// Whether the box is higher than the crystal in it, which then becomes a film of liquid in its vapour.
[[nodiscard]] bool is_film(const LatticeStart& lattice, double density);

/// The same of a specification; false for other starts, of which it is not known.
[[nodiscard]] bool is_film(const FluidSpec& spec);

/// A film that is higher than its box, or whose potential has a tail correction: that is of a homogeneous fluid.
/// @pre lattice_mistakes() finds none
[[nodiscard]] std::vector<Mistake> film_mistakes(const LatticeStart& lattice, double density, bool tail);

/// Analyses whose formulas are for a homogeneous fluid (AnalysisNeeds::homogeneous), if the start is a film.
[[nodiscard]] std::vector<Mistake> homogeneity_mistakes(const std::vector<Choice>& analyses, bool is_film);

}  // namespace ljmd
