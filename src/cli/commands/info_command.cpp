#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/plot_scripts.hpp"
#include "cli/ranks.hpp"
#include "cli/streams.hpp"
#include "compare/openmm.hpp"
#include "compare/recorded_comparison.hpp"
#include "deck/deck_schema.hpp"
#include "execution/threads.hpp"
#include "forces/few_body_force.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/program_module.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/execution/simd.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "neighbors/pair_search.hpp"
#include "observables/few_body/few_body_analysis.hpp"
#include "run/directory_report.hpp"
#include "study/study_report.hpp"

namespace ljmd {

namespace {

/// What `ljmd info` tells of: the program, or one of the others.
struct InfoOptions {
    std::string directory = {};  ///< of a run or a study
    bool keys = false;           ///< the reference page of all keys of a deck, in Markdown
    bool schema = false;         ///< a JSON Schema of decks
    bool json = false;           ///< the program or the directory, as JSON
};

std::vector<std::string_view> usable_levels() {
    std::vector<std::string_view> names;
    for (const SimdLevel level : usable_simd_levels()) {
        names.push_back(name(level));
    }
    return names;
}

/// What decks can select, with the headings of `ljmd info`.
std::vector<std::pair<std::string, std::vector<std::string>>> selectable() {
    std::vector<std::string> trajectories = plugin_names(all_trajectory_formats());
    trajectories.emplace_back("csv (few bodies)");
    return {{"potentials", PairPotential::formula_names()},
            {"truncations", PairPotential::truncation_names()},
            {"pair search", pair_search_names()},
            {"forces", plugin_names(all_few_body_forces())},
            {"integrators", plugin_names(all_integrators())},
            {"thermostats", plugin_names(all_thermostats())},
            {"barostats", plugin_names(all_barostats())},
            {"analyses", plugin_names(all_analyses())},
            {"of few bodies", plugin_names(all_few_body_analyses())},
            {"equations", plugin_names(all_equations_of_state())},
            {"trajectories", trajectories}};
}

struct OpenmmHere {
    std::string line;
    std::string version{};
    std::vector<std::string> platforms{};
};

OpenmmHere openmm_here() {
    if (!openmm_is_built_in()) {
        return {"not built in"};
    }
    try {
        return {fmt::format("{}, platforms {}, by {}", openmm_version(), fmt::join(openmm_platforms(), ", "),
                            openmm_module().string()),
                openmm_version(), openmm_platforms()};
    } catch (const InputError& error) {
        return {error.what()};
    }
}

/// The folder of Python packages that holds the one of this program: in a build beside it, in an installation where a
/// link beside the scripts leads. Empty where it was not built.
std::filesystem::path python_path() {
    namespace fs = std::filesystem;
    const fs::path here = this_program().parent_path();
    std::vector<fs::path> packages{here / "python" / "ljmd"};
    try {
        packages.push_back(plot_script(here).parent_path().parent_path() / "python" / "ljmd");
    } catch (const InputError&) {  // the program alone was copied
    }
    for (const fs::path& package : packages) {
        for (const fs::path& file : files::is_directory(package) ? files::list(package) : std::vector<fs::path>()) {
            if (file.filename().string().starts_with("_core.") && file.extension() == ".so") {
                return files::canonical(package).parent_path();
            }
        }
    }
    return {};
}

std::string info_text() {
    const BuildInfo& build = build_info();
    const ProgramModule mpi = mpi_module();
    std::string text = fmt::format("ljmd {} (commit {})\n", build.version, build.commit);
    text += fmt::format("compiler      {} {}, {}\nflags         {}\n", build.compiler, build.compiler_version,
                        build.build_type, build.flags);
    text += fmt::format("simd          {} (usable here: {})\n", name(default_simd_level()),
                        fmt::join(usable_levels(), ", "));
    text += fmt::format("threads       {} of {} processors, unless --threads says otherwise\n", default_thread_count(),
                        available_processors());
    text += fmt::format("openmm        {}\n", openmm_here().line);
    text += fmt::format("mpi           {}\n", mpi.is_there() ? mpi.path().string() : "not built in");
    const std::string python = python_path().string();
    text += fmt::format("python        {}\n", python.empty() ? "not built" : "PYTHONPATH=" + python);
    for (const auto& [word, names] : selectable()) {
        text += fmt::format("{:<14}{}\n", word, fmt::join(names, ", "));
    }
    return text;
}

std::string info_json() {
    const BuildInfo& build = build_info();
    Data integrators = Data::list();
    for (const IntegratorMethod& method : all_integrators()) {
        integrators.push_back({{"name", method.name},
                               {"meaning", method.meaning},
                               {"order", method.order},
                               {"reversible", method.reversible},
                               {"adaptive", method.adaptive},
                               {"unbounded_only", method.unbounded_only}});
    }
    const OpenmmHere openmm = openmm_here();
    const ProgramModule mpi = mpi_module();
    const std::string python = python_path().string();
    const Data json = {{"version", build.version},
                       {"commit", build.commit},
                       {"compiler", build.compiler + " " + build.compiler_version},
                       {"build_type", build.build_type},
                       {"flags", build.flags},
                       {"simd", name(default_simd_level())},
                       {"simd_levels", usable_levels()},
                       {"processors", available_processors()},
                       {"openmm", openmm.version},
                       {"mpi", mpi.is_there() ? Data(mpi.path().string()) : Data(nullptr)},
                       {"python_path", python.empty() ? Data(nullptr) : Data(python)},
                       {"openmm_platforms", openmm.platforms},
                       {"potentials", PairPotential::formula_names()},
                       {"truncations", PairPotential::truncation_names()},
                       {"pair_searches", pair_search_names()},
                       {"forces", plugin_names(all_few_body_forces())},
                       {"integrators", integrators},
                       {"thermostats", plugin_names(all_thermostats())},
                       {"barostats", plugin_names(all_barostats())},
                       {"analyses", plugin_names(all_analyses())},
                       {"few_body_analyses", plugin_names(all_few_body_analyses())},
                       {"equations_of_state", plugin_names(all_equations_of_state())},
                       {"trajectory_formats", plugin_names(all_trajectory_formats())}};
    return to_json(json) + "\n";
}

class InfoCommand : public Command {
  public:
    InfoCommand()
        : Command("info", Part::program,
                  "version, build and what decks can select; of a run or sweep, how far it got") {}

    void add_options(CLI::App& command) override {
        CLI::Option* of_run =
            command.add_option("directory", options_.directory, "directory of a run, a sweep or a reproduced table")
                ->type_name("RUNDIR");
        CLI::Option* page =
            command.add_flag("--keys", options_.keys, "the reference page of all deck keys, in Markdown");
        page->excludes(of_run);
        CLI::Option* schema = command.add_flag("--schema", options_.schema,
                                               "a JSON Schema of decks, with which editors complete and check");
        schema->excludes(of_run)->excludes(page);
        command.add_flag("--json", options_.json, "print it as JSON")->excludes(page)->excludes(schema);
    }

    void run() override {
        if (options_.keys) {
            print_result(deck_reference_page());
        } else if (options_.schema) {
            print_result(deck_json_schema());
        } else if (options_.directory.empty()) {
            print_result(options_.json ? info_json() : info_text());
        } else if (holds_study(options_.directory)) {
            print_document(study_report(options_.directory, result_columns()), options_.json);
        } else if (!input_is_there(std::filesystem::path(options_.directory) / "run.json") &&
                   holds_comparison(options_.directory)) {
            print_document(comparison_report(options_.directory), options_.json);
        } else {
            print_document(directory_report(options_.directory), options_.json);
        }
    }

  private:
    InfoOptions options_;
};

}  // namespace

std::shared_ptr<Command> info_command() {
    return std::make_shared<InfoCommand>();
}

}  // namespace ljmd
