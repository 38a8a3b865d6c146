#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"

namespace ljmd {

/// The frame of the centre of mass, in which diffusion and the correlations of velocities are measured: they are the
/// same for all observers that move uniformly, and under a uniform force, which moves the centre of mass and nothing
/// else. With R = sum m r/M and V = sum m v/M of all atoms,
///
///     r_i - R, v_i - V
///
/// Where thermostats push the centre of mass, the frame leaves out its own diffusion, T time/N. Columns are by id.
/// A force that differs between atoms distinguishes a frame of its own, the one in which its sources rest, and holds or
/// drives the centre of mass in it: there is no diffusion then that a frame does not change, see withdraw_diffusion().
/// The heat flux and the mechanical stress are relative to V in the same way (heat_flux.hpp, thermodynamics.hpp).

/// Unwrapped positions relative to R [sigma], shape (3, N).
[[nodiscard]] Eigen::Matrix3Xd positions_about_centre(const State& state);

/// Velocities relative to V [sigma/tau], shape (3, N).
[[nodiscard]] Eigen::Matrix3Xd velocities_about_centre(const State& state);

/// Remark on the motion of one atom.
inline constexpr const char* moves_with_centre = "a single atom has no motion about the centre of mass";

/// Why diffusion has no value under a force that may differ between atoms.
inline constexpr const char* no_frame_of_diffusion =
    "diffusion is measured about the centre of mass, which only a uniform force leaves as it is";

/// Take back the values of diffusion. @param why  the remark in their place
void withdraw_diffusion(std::vector<ObservableAverage>& averages, const std::string& why);

}  // namespace ljmd
