#pragma once

#include <optional>
#include <vector>

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/observables/statistics/jackknife_blocks.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/dynamics/wave_vectors.hpp"
#include "observables/transport/correlation_windows.hpp"
#include "observables/transport/lag_times.hpp"

namespace ljmd {

/// Scattering functions of a liquid at wave vectors of the box, averaged over shells of them:
///
///     rho(k, t) = sum_j exp(-i k . r_j(t)),   j(k, t) = sum_j v_j(t) exp(-i k . r_j(t))
///
///     F(k, t)   = <rho(k, t) rho*(k, 0)>/N                                intermediate scattering, F(k, 0) = S(k)
///     F_s(k, t) = <sum_j exp(-i k . (r_j(t) - r_j(0)))>/N                 its self part
///     C_L(k, t) = k^2/N <j_L(k, t) j_L*(k, 0)>,   j_L = j . k/|k|         longitudinal current, = -d^2 F/dt^2
///     C_T(k, t) = k^2/(2 N) <j_T(k, t) . j_T*(k, 0)>                      transverse current
///     S(k, w)   = 1/pi integral from 0 to t_max of F(k, t) W(t) cos(w t) dt,   W(t) = cos^2(pi t/(2 t_max))
///
/// S is for w of both signs: its integral over all of them is S(k). W is Hann's window, which is 1 at t = 0, so that
/// the integral over w is unchanged; it smooths S over about pi/t_max. Real parts are taken: imaginary parts vanish in
/// a fluid. Positions and velocities are relative to the centre of mass (centre_frame.hpp): so C_L(k, 0) and C_T(k, 0)
/// are k^2 T/m (1 - S(k)/N) and the short times of F_s are those of k^2 T/m (1 - 1/N).
///
/// F, currents and S: averages within windows of twice the largest time over all time origins, errors by block
/// averaging over windows. F_s: time origins equally spaced, `origins` of them within the largest time; errors by block
/// averaging over origins.
///
/// Modes, of each wave number, with errors by a jackknife over 16 to 64 blocks of windows or origins (none with fewer):
/// the speed c = w_s/k and the attenuation Gamma = z_s/k^2 of sound and the viscosity eta(k) of hydrodynamic_modes.hpp,
/// where there are any, and D(k) = ln(F_s(k, t_max/2)/F_s(k, t_max))/(k^2 t_max/2), which is the coefficient of
/// diffusion as k goes to 0, where F_s(k, t_max) >= 0.02; k^2 is the mean over the shell.
///
/// Tables, one row for each wave number and time or frequency: `fkt`: k, time, F, C_L, C_T with errors. `fskt`: k,
/// time, F_s, error. `skw`: k, angular_frequency, S_kw, error. One row for each wave number: `modes`: k, sound_velocity
/// [sigma/tau], sound_attenuation [sigma^2/tau], transverse_viscosity [epsilon tau/sigma^3], self_diffusion
/// [sigma^2/tau], each with its error, NaN where there is none; no such table with fewer than 8 times. Sources: Hansen
/// and McDonald, Theory of Simple Liquids, sections 7.4 and 7.5; Levesque, Verlet and Kurkijarvi (1973),
/// doi:10.1103/PhysRevA.7.1690
class Scattering : public Analysis {
  public:
    /// @param density  [sigma^-3]
    /// @param window   configurations per window, greater than lags.count
    /// @param origins  at least 1; more than lags.count have no effect
    Scattering(Index atoms, double density, std::vector<WaveShell> shells, const LagTimes& lags, Index window,
               Index origins);

    /// Memory of the blocks that modes are found from, of so many windows and time origins [bytes].
    [[nodiscard]] static double bytes_of_modes(Index shells, const LagTimes& lags, Index windows, Index origins);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return samples_; }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    /// sound_velocity at the smallest wave number, or why there is none.
    [[nodiscard]] std::vector<ObservableAverage> observables() const override;
    void archive(Archive& a) override;

  private:
    /// exp(-i k . r) of each atom: columns 2 v and 2 v + 1 are real and imaginary parts for vector v.
    using Phases = Eigen::MatrixXd;

    /// Phases at a time origin, and F_s of each shell at the times passed so far, (shells, times).
    struct Origin {
        Phases phases;
        Eigen::MatrixXd found;

        void archive(Archive& a) { a(phases, found); }
    };

    [[nodiscard]] Phases phases_of(const Eigen::Matrix3Xd& positions, const Vec3& edges,
                                   const Execution& execution) const;
    void add_modes(const Phases& phases, const Eigen::Matrix3Xd& velocities, const Execution& execution);
    void add_self(Phases phases, const Execution& execution);
    void add_to_modes(const Eigen::VectorXd& functions);
    [[nodiscard]] std::optional<DataTable> modes() const;
    static constexpr Index functions = 4;  ///< F, C_L, C_T, S
    [[nodiscard]] static Index collective_width(const LagTimes& lags);
    [[nodiscard]] Eigen::VectorXd modes_of(const Eigen::VectorXd& collective) const;
    [[nodiscard]] Eigen::VectorXd diffusion_of(const Eigen::VectorXd& self) const;
    [[nodiscard]] Eigen::VectorXd smoothed_spectrum(const Eigen::VectorXd& correlation) const;

    Index atoms_;
    double density_;
    std::vector<WaveShell> shells_;
    std::vector<WaveVector> vectors_;  ///< of all shells
    LagTimes lags_;
    Every every_;
    Index frames_between_origins_;
    CosineTransform cosines_;
    Index samples_ = 0;
    Index frames_ = 0;                           ///< since the last interruption
    std::vector<CorrelationWindows> densities_;  ///< of each shell
    std::vector<CorrelationWindows> longitudinal_;
    std::vector<CorrelationWindows> transverse_;
    std::vector<Origin> origins_;  ///< incomplete ones, oldest first
    BlockingAccumulator means_;    ///< of each shell F, C_L, C_T, S
    BlockingAccumulator self_;     ///< of each shell F_s
    JackknifeBlocks collective_;   ///< of each shell F, C_T, C_L(k, 0)
    JackknifeBlocks halves_;       ///< of each shell F_s at half of the largest time and at it
};

}  // namespace ljmd
