#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/given_parts.hpp"
#include "io/files/open_directory.hpp"
#include "ljmd/detail/deck/run_files.hpp"
#include "ljmd/detail/engine/few_body_spec.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

/// A run with a directory, as values: what is computed, what is written and where, and the deck that says the same,
/// which its record keeps. A deck is one way to make one, a FluidSpec another.
struct RunPlan : RunFiles {
    std::string path;                        ///< of the deck as the user gave it; else what stands for it in messages
    std::string source;                      ///< the text of the deck
    std::vector<std::string> settings = {};  ///< the `--set` arguments that were applied, in order

    /// Of a start file nothing is read: the configuration is empty. A potential that a program gave has a stand-in
    /// here, see fluid_spec().
    std::variant<FluidSpec, FewBodySpec> spec = {};
    Precision precision = Precision::double_precision;  ///< of the pair sum

    std::filesystem::path directory = {};
    std::optional<OpenDirectory> locked = {};  ///< the same directory, if a command has locked it; shares the lock
    std::optional<std::filesystem::path> start_file = {};  ///< that the run starts from; none: its start is at hand
    bool report = false;                                   ///< whether `ljmd run` ends with a page about the run
    GivenParts given = {};                                 ///< what a program gives to the run beside this

    [[nodiscard]] bool is_fluid() const { return std::holds_alternative<FluidSpec>(spec); }
    [[nodiscard]] const FewBodySpec& few_bodies() const { return std::get<FewBodySpec>(spec); }  ///< @pre !is_fluid()

    // Of either kind.
    [[nodiscard]] std::vector<Stage>& stages();
    [[nodiscard]] const std::vector<Stage>& stages() const;
    [[nodiscard]] Index sample_every() const;
    [[nodiscard]] const std::optional<SubstanceUnits>& units() const;  ///< none for few bodies

    /// The output directory: the locked one, even if its path leads elsewhere by now. @throws FileError
    [[nodiscard]] OpenDirectory outputs() const { return locked ? *locked : OpenDirectory(directory); }
};

/// "fluid" or "few-body", as in run.json.
[[nodiscard]] std::string kind_name(const RunPlan& plan);

/// Refuse a run of the other kind. @param otherwise  says what it lacks  @throws InputError
void require_fluid(const RunPlan& plan, const std::string& otherwise);
void require_few_bodies(const RunPlan& plan, const std::string& otherwise);

/// The specification of a fluid, with the potential that a program gave.
/// @pre plan.is_fluid()  @throws DataError  the run has a potential which is not known here
[[nodiscard]] FluidSpec fluid_spec(const RunPlan& plan);

}  // namespace ljmd
