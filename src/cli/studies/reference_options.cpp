#include "ljmd/cli/studies/reference_options.hpp"

#include "ljmd/execution/threads.hpp"
#include "ljmd/input/reduced_number.hpp"
#include "ljmd/study/replicas.hpp"

namespace ljmd {

namespace {

CLI::Validator reduced_number(const std::string& unit, Dimension dimension) {
    return {[=](const std::string& text) { return not_reduced(text, unit, dimension); }, ""};
}

}  // namespace

ReferenceCommand::ReferenceCommand(CLI::App& app)
    : command_(*app.add_subcommand("reference",
                                   "values of the Lennard-Jones fluid at a state, to the errors asked for, with what "
                                   "they are uncertain by; an interrupted one is resumed")) {
    ReferenceRequest& request = options_.request;
    command_.add_option("--temperature", request.temperature, "in epsilon/k_B")
        ->required()
        ->type_name("T")
        ->check(reduced_number("epsilon/k_B", Dimension::temperature));
    CLI::Option* density = command_.add_option("--density", request.density, "atoms per sigma^3")
                               ->type_name("RHO")
                               ->check(reduced_number("atoms per sigma^3", Dimension::density));
    command_.add_option("--pressure", request.pressure, "in epsilon/sigma^3, instead of a density")
        ->type_name("P")
        ->check(reduced_number("epsilon/sigma^3", Dimension::pressure))
        ->excludes(density);
    command_
        .add_option("--error", options_.errors,
                    "statistical errors to reach; by default 0.1 % of the energy (at least 0.0005 T), and 1 % of rho T "
                    "for the pressure")
        ->type_name("PROPERTY=E,...")
        ->delimiter(',');
    command_
        .add_option("--properties", options_.properties,
                    "beside energy, pressure and Z: c_v, c_p, kappa_T, alpha_p, gamma_V, w, mu_JT, mu_ex, g, S, D, "
                    "eta, eta_v, lambda, or their full names; all")
        ->type_name("NAME,...")
        ->delimiter(',');
    command_
        .add_option("--atoms", request.atoms,
                    "4 n^3 of them: 108, 256, 500, 864, ...; by default 864, more where the fluid is compressible")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    command_.add_option("--replicas", request.replicas, "independent runs of each kind, 4 by default")
        ->type_name("N")
        ->check(CLI::Range(Index{2}, max_replicas));
    command_.add_option("--max-steps", request.max_steps, "of each run, 2000000 by default")
        ->type_name("N")
        ->check(CLI::Range(Index{1000}, max_steps));
    command_.add_option("--seed", request.seed, "of all random numbers, 1 by default")
        ->type_name("N")
        ->check(CLI::Range(Index{0}, Index{1} << 53U));
    command_.add_flag("--metastable", request.metastable,
                      "accept a state that is not the stable one, as long as it lasts");
    command_.add_option("--jobs", options_.jobs, "replicas at a time; one for each processor by default")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    command_.add_option("--out", options_.out, "directory, runs/reference-T...-rho... by default")->type_name("DIR");
    command_.add_flag("--force", options_.force, "replace the runs of another request");
    command_.add_flag("--quiet", options_.quiet, "no progress");
    command_.add_flag("--json", options_.json, "print the result as JSON");
}

}  // namespace ljmd
