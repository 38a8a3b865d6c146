#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// What a file is told that it leaves open.
struct ReadingOptions {
    /// Whose interaction analyses take that need one, whose units a file in SI units has, and whose thermostat says at
    /// which temperature its last stage was sampled.
    std::optional<FluidSpec> fluid = {};
    bool energies = false;                       ///< analyze() also averages energies and pressures; needs `fluid`
    std::optional<double> from = {};             ///< frames before this time are left out [tau]
    std::optional<double> time_step = {};        ///< between steps, where the file has no times [tau]
    std::optional<bool> wrapped_positions = {};  ///< where neither the file nor the motion of the atoms tells
    std::string group = {};                      ///< of an H5MD file with several groups of particles
    std::string xyz_comment = {};                ///< what the comment lines of an extended XYZ file lack
};

/// Results from the frames of a trajectory.
struct TrajectoryResult {
    std::vector<ObservableAverage> averages;
    std::vector<DataTable> tables;
    std::vector<std::string> warnings;
    bool used_displacements = false;  ///< so whether positions are wrapped matters
};

/// The frames of a file, of ljmd or of another program: H5MD, extended XYZ or LAMMPS dump, known by its content.
///
///     const Trajectory frames("run.h5");
///     const TrajectoryResult found = frames.analyze({analysis("rdf", {{"bins", 200}}), analysis("msd")});
///     frames.each([](const Configuration& frame) { std::cout << frame.positions.size() << '\n'; });
///
/// The file is read when this is made, and again by each call that needs its positions; one frame is in memory at a
/// time. It is in reduced units, or in SI units if the options have a fluid with units. Two threads use it one after
/// the other: its analyses share threads. Messages name an option of `ljmd analyze` where the same is meant here.
class Trajectory {
  public:
    /// @throws DataError  it is missing, of unknown format, or damaged  @throws InputError  options that do not fit it
    explicit Trajectory(const std::filesystem::path& path, const ReadingOptions& options = {});
    ~Trajectory();
    Trajectory(Trajectory&&) noexcept;
    Trajectory& operator=(Trajectory&&) noexcept;
    Trajectory(const Trajectory&) = delete;
    Trajectory& operator=(const Trajectory&) = delete;

    [[nodiscard]] Index frames() const;
    [[nodiscard]] Index atoms() const;
    [[nodiscard]] Vec3 edges() const;                                ///< of the box of the first frame [sigma]
    [[nodiscard]] bool has_velocities() const;                       ///< in all frames
    [[nodiscard]] const std::vector<double>& times() const;          ///< of the frames [tau]; empty if they have none
    [[nodiscard]] std::optional<double> spacing() const;             ///< of all measured frames in time [tau]
    [[nodiscard]] const std::vector<std::string>& warnings() const;  ///< remarks on the file

    /// Call a function with each frame, as the file has it. @throws DataError  the file has changed
    void each(const std::function<void(const Configuration&)>& take) const;

    /// What analyses find in the frames, in one pass. Their `every` counts frames. The temperature is among the
    /// averages if there are velocities.
    /// @param analyses  as analysis() makes them, each at most once; none: those that go with the file
    /// @throws InputError  the file or the options lack what one needs: velocities, equally spaced frames, all atoms,
    /// an interaction, or whether positions are wrapped  @throws DataError  the file has changed
    [[nodiscard]] TrajectoryResult analyze(const std::vector<Choice>& analyses = {}) const;

  private:
    struct Parts;
    /// @throws InputError if this was moved to another one
    [[nodiscard]] Parts& parts() const;

    std::unique_ptr<Parts> parts_;
};

/// The configuration in a file, in any format that a deck's `start` takes, known by its content; of a trajectory its
/// last frame. @param options  `fluid`, for its units, and `xyz_comment` count
/// @throws DataError with file, line and frame, when the file is missing, unknown or wrong
[[nodiscard]] Configuration configuration_in(const std::filesystem::path& path, const ReadingOptions& options = {});

}  // namespace ljmd
