#pragma once

#include <vector>

#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// Diffusion in an infinite system from that in a periodic cube of edge L, which hydrodynamic interaction with its
/// images slows down:
///
///     D_inf = D + 2.837297 T/(6 pi eta L)
///
/// The error is from D and eta, taken as independent; T is known much better.
/// @return diffusion_infinite_system if the averages contain diffusion, viscosity and temperature and the box is a
/// cube; without a value if one of them has none or if the viscosity is not above zero
/// Source: Yeh and Hummer (2004), doi:10.1021/jp0477147
[[nodiscard]] std::optional<ObservableAverage> diffusion_in_infinite_system(
    const std::vector<ObservableAverage>& averages, const Box& box);

}  // namespace ljmd
