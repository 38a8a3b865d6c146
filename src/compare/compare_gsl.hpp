#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/few_body_system.hpp"
#include "run/run.hpp"

namespace ljmd {

/// Comparison of a few-body run with the adaptive solution of its equations of motion, at equal times.
///
/// Errors are absolute, in the deck's units: the largest position error and velocity error of a body, and the
/// deviations of total energy and angular momentum from their start values.
struct GslComparison {
    struct Row {
        Index step;
        double time;
        double position_error;
        double velocity_error;
        double energy_error;
        double angular_momentum_error;
        double reference_error;  ///< distance of two references with tolerances 1e-13 and 1e-12; unless it is far below
                                 ///< position_error, the motion is too chaotic to be followed
    };
    std::vector<Row> rows;
    double largest_position_error = 0.0;
    double largest_energy_error = 0.0;
    double largest_angular_momentum_error = 0.0;
    /// Largest |E - E0| of the reference, divided by the largest |potential energy|.
    double reference_energy_error = 0.0;
    double reference_energy_tolerance = 1e-9;

    [[nodiscard]] bool passed() const { return reference_energy_error <= reference_energy_tolerance; }
};

/// Run the deck's stages and compare them with GSL's adaptive Runge-Kutta-Prince-Dormand method.
/// @throws InputError    for a fluid, and for a stage that runs backwards
/// @throws PhysicsError  when bodies collide
[[nodiscard]] GslComparison compare_with_gsl(const Deck& deck, RunListener& listener);

[[nodiscard]] std::string comparison_table(const GslComparison& comparison, const Deck& deck);
[[nodiscard]] std::string comparison_json(const GslComparison& comparison, const Deck& deck);

/// Write compare-gsl.csv and compare-gsl.json into a directory, creating it if needed.
/// @param force  whether existing files of these names are replaced
/// @throws OutputRefused as require_writable(); FileError
void write_comparison(const GslComparison& comparison, const Deck& deck, const std::filesystem::path& directory,
                      bool force = false);

}  // namespace ljmd
