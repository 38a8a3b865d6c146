#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/studies/reference_phase.hpp"
#include "core/text.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/replacement_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "io/tables/json_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"
#include "study/child_run.hpp"
#include "study/error_in_brackets.hpp"
#include "study/reference/energy_kept.hpp"
#include "study/reference/reference_report.hpp"
#include "study/replicas.hpp"
#include "study/study_report.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd reference`.
struct ReferenceOptions {
    ReferenceRequest request{};             ///< without properties and errors
    std::vector<std::string> properties{};  ///< names, aliases, "all"; empty: energy and pressure
    std::vector<std::string> errors{};      ///< "NAME=NUMBER"
    std::string out{};                      ///< directory; empty: runs/reference-T...
    int jobs = 0;                           ///< replicas at a time; 0: the number of processors
    bool force = false;
    bool quiet = false;
    bool json = false;
};

/// Full names, without repetition; those that every reference has first.
std::vector<std::string> full_names(const std::vector<std::string>& asked) {
    std::vector<std::string> names{"potential_energy", "pressure", "compressibility_factor"};
    const auto add = [&](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    };
    for (const std::string& name : asked) {
        if (name == "all") {
            for (const ReferenceProperty& property : reference_properties()) {
                add(property.name);
            }
        } else {
            add(reference_property(name).name);
        }
    }
    return names;
}

std::vector<WantedError> wanted_errors(const std::vector<std::string>& asked) {
    std::vector<WantedError> wanted;
    for (const std::string& one : asked) {
        const std::size_t equals = one.find('=');
        const auto number = to_number(std::string_view(one).substr(std::min(equals, one.size() - 1) + 1));
        if (equals == std::string::npos || !number) {
            throw InputError(
                fmt::format("--error: {} is not allowed: PROPERTY=NUMBER, as in energy=0.001", in_quotes(one)));
        }
        wanted.push_back({reference_property(one.substr(0, equals)).name, *number});
    }
    return wanted;
}

/// Why runs go on though an error is small enough.
std::string why_not_yet(const ReachedError& error, const ReferenceValue& value) {
    if (error.reached || !(error.error <= error.wanted.error)) {
        return "";
    }
    return value.independent < least_independent_samples
               ? fmt::format(", not yet: {:.0f} independent samples of {:.0f}", value.independent,
                             least_independent_samples)
               : ", not yet: the error is a guess";
}

/// Wait for errors that more steps can reach, and say how far they are.
/// @param values  of the folder of the phase
template <class Values>
std::vector<ReferenceValue> reach_errors(ReferencePhase& phase, const ReferenceSetup& setup, const Values& values,
                                         bool quiet) {
    phase.complete();
    for (;;) {
        std::vector<ReferenceValue> found = values(phase.folder());
        const std::vector<ReachedError> errors = reached_errors(setup.request.errors, found);
        if (!quiet) {
            for (const ReachedError& one : errors) {
                const auto value = std::ranges::find(found, one.wanted.observable, &ReferenceValue::name);
                print_message(value->mean ? fmt::format("  {} {}, wanted {:.2g}{}\n", value->name,
                                                        with_error_in_brackets(*value->mean, one.error),
                                                        one.wanted.error, why_not_yet(one, *value))
                                          : fmt::format("  {}: no value yet\n", value->name));
            }
        }
        const auto next = next_length(errors, phase.steps(), setup.request.max_steps);
        if (!next) {
            return found;
        }
        phase.lengthen(*next);
    }
}

/// Steps before sampling: twice what the slowest pilot run has taken, and at least 1000.
Index equilibration_steps(const FoundEquilibration& pilot) {
    constexpr Index least = 1000;
    return std::max(least, 2 * pilot.rows * rows_every);
}

/// Pilot runs, until they have enough independent samples behind their equilibration to know it.
FoundEquilibration run_pilot(ReferencePhase& pilot, const ReferenceSetup& setup) {
    constexpr double enough = 20.0;
    constexpr Index longest = 64 * pilot_steps;
    pilot.complete();
    for (;;) {
        std::vector<CanonicalSeries> series;
        for (const fs::path& run : pilot.folder().runs) {
            series.push_back(canonical_series(run, setup.density, setup.request.temperature));
        }
        const FoundEquilibration found = found_equilibration(series);
        if (found.independent >= enough || pilot.steps() >= longest) {
            return found;
        }
        pilot.lengthen(2 * pilot.steps());
    }
}

double halves_of(const ReferenceSetup& setup, const ReplicaFolder& folder) {
    std::vector<std::vector<double>> energies;
    for (const fs::path& run : folder.runs) {
        energies.push_back(canonical_series(run, setup.density, setup.request.temperature).energy);
    }
    return difference_of_halves(energies);
}

/// The largest translational order with which a replica began to sample.
std::optional<double> largest_order(const ReplicaFolder& folder) {
    std::optional<double> largest;
    for (const fs::path& run : folder.runs) {
        read_json(run / "results.json", "the results of a run", [&](const Data& results) {
            const Data* order = results.find("translational_order_at_sampling");
            if (order != nullptr && order->is_number()) {
                largest = std::max(largest.value_or(order->number()), order->number());
            }
            return 0;
        });
    }
    return largest;
}

/// The request, for whoever finds the directory.
Data request_data(const ReferenceRequest& request) {
    Data errors = Data::object();
    for (const WantedError& wanted : request.errors) {
        errors[wanted.observable] = wanted.error;
    }
    return {{"program", "ljmd"},
            {"kind", "reference"},
            {"temperature", request.temperature},
            {"density", request.density},
            {"pressure", request.pressure},
            {"properties", request.properties},
            {"errors", errors},
            {"atoms", request.atoms},
            {"replicas", request.replicas},
            {"max_steps", request.max_steps},
            {"seed", request.seed},
            {"metastable", request.metastable}};
}

/// Refuse a directory with a reference of another state or of other runs, or with something else. Wanted errors and
/// the largest number of steps may differ: they only make runs longer. @throws InputError
void require_same_request(const ReferenceRequest& request, const fs::path& out, bool force) {
    constexpr const char* consequence = "Nothing was run";
    require_no_run(out, consequence);
    if (files::is_taken(out / "sweep.json")) {
        throw InputError(fmt::format("{} holds a sweep or replicas. {}.\n  choose another directory with --out",
                                     out.string(), consequence));
    }
    const fs::path file = out / reference_file;
    require_no_outputs(out, {"results.json", "results.txt", "rdf.csv", "sk.csv"}, files::is_taken(file) || force,
                       consequence);
    if (!files::is_taken(file) || force) {
        return;
    }
    const Data now = request_data(request);
    read_json(file, "the request of a reference", [&](const Data& before) {
        for (const char* key :
             {"temperature", "density", "pressure", "properties", "atoms", "replicas", "seed", "metastable"}) {
            if (before.at(key) != now.at(key)) {
                throw InputError(fmt::format(
                    "{} holds a reference with another value of {}. {}.\n  choose another directory with --out, or "
                    "replace it with --force",
                    out.string(), key, consequence));
            }
        }
        return 0;
    });
}

/// Put the tables that were asked for beside the results.
void copy_tables(const ReferenceSetup& setup, const ReplicaFolder& canonical, const OpenDirectory& out) {
    for (const auto& [property, table] : {std::pair{"rdf", "rdf.csv"}, std::pair{"structure_factor", "sk.csv"}}) {
        const auto& asked = setup.request.properties;
        if (std::ranges::find(asked, property) != asked.end() && files::exists(canonical.merged / table)) {
            write_file_atomically(out / table, to_csv(read_csv(canonical.merged / table)));
        }
    }
}

class ReferenceCommand : public Command {
  public:
    ReferenceCommand()
        : Command("reference", Part::studies,
                  "values of the Lennard-Jones fluid at a state, to the errors asked for, with what "
                  "they are uncertain by; an interrupted one is resumed") {}

    void add_options(CLI::App& command) override {
        ReferenceRequest& request = options_.request;
        command.add_option("--temperature", request.temperature, "in epsilon/k_B")
            ->required()
            ->type_name("T")
            ->check(reduced("epsilon/k_B", Dimension::temperature));
        CLI::Option* density = command.add_option("--density", request.density, "atoms per sigma^3")
                                   ->type_name("RHO")
                                   ->check(reduced("atoms per sigma^3", Dimension::density));
        command.add_option("--pressure", request.pressure, "in epsilon/sigma^3, instead of a density")
            ->type_name("P")
            ->check(reduced("epsilon/sigma^3", Dimension::pressure))
            ->excludes(density);
        command
            .add_option(
                "--error", options_.errors,
                "statistical errors to reach; by default 0.1 % of the energy (at least 0.0005 T), and 1 % of rho T "
                "for the pressure")
            ->type_name("PROPERTY=E,...")
            ->delimiter(',');
        command
            .add_option("--properties", options_.properties,
                        "beside energy, pressure and Z: c_v, c_p, kappa_T, alpha_p, gamma_V, w, mu_JT, mu_ex, g, S, D, "
                        "eta, eta_v, lambda, or their full names; all")
            ->type_name("NAME,...")
            ->delimiter(',');
        command
            .add_option("--atoms", request.atoms,
                        "4 n^3 of them: 108, 256, 500, 864, ...; by default 864, more where the fluid is compressible")
            ->type_name("N")
            ->check(CLI::PositiveNumber);
        command.add_option("--replicas", request.replicas, "independent runs of each kind, 4 by default")
            ->type_name("N")
            ->check(CLI::Range(Index{2}, max_replicas));
        command.add_option("--max-steps", request.max_steps, "of each run, 2000000 by default")
            ->type_name("N")
            ->check(CLI::Range(Index{1000}, max_steps));
        command.add_option("--seed", request.seed, "of all random numbers, 1 by default")
            ->type_name("N")
            ->check(CLI::Range(Index{0}, Index{1} << 53U));
        command.add_flag("--metastable", request.metastable,
                         "accept a state that is not the stable one, as long as it lasts");
        add_jobs(command, options_.jobs, "replicas at a time; one for each processor by default");
        command.add_option("--out", options_.out, "directory, runs/reference-T...-rho... by default")->type_name("DIR");
        command.add_flag("--force", options_.force, "replace the runs of another request");
        command.add_flag("--quiet", options_.quiet, "no progress");
        command.add_flag("--json", options_.json, "print the result as JSON");
    }

    void run() override {
        install_stop_handlers();
        ReferenceRequest request = options_.request;
        request.properties = full_names(options_.properties);
        request.errors = wanted_errors(options_.errors);
        const ReferenceSetup setup = reference_setup(request);
        const fs::path out = options_.out.empty() ? fmt::format("runs/reference-T{}-{}", request.temperature,
                                                                request.density ? fmt::format("rho{}", *request.density)
                                                                                : fmt::format("p{}", *request.pressure))
                                                  : options_.out;
        require_same_request(request, out, options_.force);
        make_directory(out);
        const DirectoryLock lock(out);
        if (!options_.quiet) {
            print_message(fmt::format("{} at T = {}, rho = {:.6g}: {} atoms, cutoff {}\n", name_of(setup.phase.phase),
                                      request.temperature, setup.density, setup.atoms,
                                      setup.potential.cutoff().radius));
        }

        write_file_atomically(lock.directory() / reference_file, to_json(request_data(request)) + "\n");
        const ReplicaOptions how{options_.jobs, options_.force, options_.quiet};
        ReferencePhase pilot("pilot", out, pilot_deck(setup), pilot_steps, request.replicas, how);
        ReferenceFindings findings{.equilibration = 0,
                                   .pilot = run_pilot(pilot, setup),
                                   .canonical = {},
                                   .order = std::nullopt,
                                   .halves = 0.0,
                                   .values = {},
                                   .errors = {}};
        findings.equilibration = equilibration_steps(findings.pilot);

        ReferencePhase canonical("canonical", out, canonical_deck(setup, findings.equilibration),
                                 first_steps(setup, false), request.replicas, how);
        findings.values = reach_errors(
            canonical, setup, [&](const ReplicaFolder& folder) { return canonical_values(setup, folder); },
            options_.quiet);
        findings.canonical = {canonical.steps(), setup.time_step};
        findings.order = largest_order(canonical.folder());
        findings.halves = halves_of(setup, canonical.folder());
        if (request.pressure && findings.values.at(1).mean) {
            findings.density = density_at_pressure(setup, findings.values.at(1));
        }
        if (request.needs(MeasuredBy::transport)) {
            const double energy = found_total_energy(setup, canonical.folder());
            ReferencePhase transport("transport", out, transport_deck(setup, findings.equilibration, energy),
                                     first_steps(setup, true), request.replicas, how);
            const std::vector<ReferenceValue> values = reach_errors(
                transport, setup, [&](const ReplicaFolder& folder) { return transport_values(setup, folder); },
                options_.quiet);
            findings.values.insert(findings.values.end(), values.begin(), values.end());
            findings.transport = {transport.steps(), transport_time_step(setup)};
            const double uncertainty = temperature_uncertainty(transport.folder().runs, request.temperature);
            if (const std::string warning = energy_warning(uncertainty); !warning.empty()) {
                findings.warnings.push_back(warning);
            }
        }
        findings.errors = reached_errors(setup.request.errors, findings.values);

        lock.directory().require_at_its_path();
        copy_tables(setup, canonical.folder(), lock.directory());
        const Document whole = reference_report(setup, findings, std::nullopt);
        write_file_atomically(lock.directory() / "results.json", to_json(whole.data) + "\n");
        write_file_atomically(lock.directory() / "results.txt", whole.text);
        Document shown = reference_report(setup, findings, result_columns());
        shown.text += fmt::format("\nfiles: {}\n", out.string());
        print_document(shown, options_.json);
    }

  private:
    ReferenceOptions options_;
};

}  // namespace

std::shared_ptr<Command> reference_command() {
    return std::make_shared<ReferenceCommand>();
}

}  // namespace ljmd
