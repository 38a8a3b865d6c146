#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "study/reference/reference_length.hpp"

namespace ljmd {

/// Replicas of one kind, as a report tells of them.
struct ReferenceRuns {
    Index steps;  ///< of the sampled stage, each
    double time_step;
};

/// All that a reference has found.
struct ReferenceFindings {
    Index equilibration;  ///< steps before sampling
    FoundEquilibration pilot;
    ReferenceRuns canonical;
    std::optional<ReferenceRuns> transport{};
    std::optional<double> order;              ///< largest translational order of a replica when sampling began
    double halves;                            ///< difference_of_halves() of the energies
    std::optional<ReferenceValue> density{};  ///< at the pressure of the request
    std::vector<ReferenceValue> values;
    std::vector<ReachedError> errors;
    std::vector<std::string> warnings{};  ///< of the runs
};

/// Number of standard errors by which halves of the runs may differ before the fluid counts as changing.
inline constexpr double largest_difference_of_halves = 4.5;

/// The report. Data: each property by its name, with mean, statistical_error, systematic_error, total_error,
/// cutoff_correction, size_correction, equation_of_state (by thol2016), equations_of_state (all), unit, remark;
/// temperature, density, phase, phase_diagram, runs, errors, warnings, citation. Text: the table, remarks, a paragraph
/// to cite. @param screen  columns; none: any width
[[nodiscard]] Document reference_report(const ReferenceSetup& setup, const ReferenceFindings& findings,
                                        std::optional<std::size_t> screen);

}  // namespace ljmd
