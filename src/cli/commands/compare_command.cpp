#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/judge/judge_command.hpp"
#include "cli/progress.hpp"
#include "cli/streams.hpp"
#include "compare/compare_gsl.hpp"
#include "compare/crosscheck_report.hpp"
#include "deck/deck_system.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

namespace {

void compare_bodies(const Deck& deck, const DeckOptions& options, const std::string& out) {
    Progress progress(std::nullopt, total_steps(deck.stages()), options.quiet);
    const GslComparison comparison = compare_with_gsl(deck, progress);
    progress.clear_line();
    if (!out.empty()) {
        write_comparison(comparison, deck, out, options.force);
    }
    print_result(options.json ? comparison_json(comparison, deck) + "\n" : comparison_table(comparison, deck));
    if (!comparison.passed()) {
        throw PhysicsError("the reference does not conserve the energy: bodies come too close for it");
    }
}

void compare_fluid(const Deck& deck, CheckedRun fluid, const DeckOptions& options, const CrosscheckOptions& compared,
                   const std::string& out) {
    Progress progress(fluid.atoms(), steps_before_crosscheck(deck), options.quiet);
    const auto say = [&](const std::string& text) {
        if (!options.quiet) {
            progress.clear_line();
            print_message(text + "\n");
        }
    };
    FluidSystem simulation = make_fluid(fluid_spec(deck, std::move(fluid.start.value())), fluid.execution,
                                        [&](const std::string& text) { progress.warning(text); });
    const Crosscheck found = crosscheck(deck, simulation, compared, progress, say);
    progress.clear_line();
    if (!out.empty()) {
        write_crosscheck(found, deck, compared, out, options.force);
    }
    print_result(options.json ? crosscheck_json(found, deck, compared) + "\n"
                              : crosscheck_table(found, deck, compared) + (out.empty() ? "" : told_files(out)));
    if (!found.passed()) {
        throw PhysicsError(fmt::format("ljmd and {} differ: {} of {} checks failed", found.peer, found.failures(),
                                       found.checks.size()));
    }
}

/// Refuse options that would have no effect.
void check_compare_options(const CrosscheckOptions& compared) {
    const CrosscheckOptions usual{.with = compared.with};
    const bool follows = compared.steps == usual.steps && compared.frames == usual.frames;
    if (compared.platform != usual.platform && compared.with != "openmm") {
        throw InputError(fmt::format("--platform is OpenMM's: '{}' has none", compared.with));
    }
    if (compared.timeout != usual.timeout) {
        throw InputError(fmt::format("--timeout is of an engine, --with command:...: '{}' has none", compared.with));
    }
    if (compared.with == "gsl" && !(follows && compared.parts.empty())) {
        throw InputError(
            "--steps, --frames and --parts are for a fluid: few bodies are compared over the deck's steps");
    }
    if (!compared.wants("trajectory") && !follows) {
        throw InputError("--steps and --frames are those of the trajectory, which --parts leaves out");
    }
}

class CompareCommand : public Command {
  public:
    CompareCommand() : Command("compare", Part::peers, "compare a deck's motion with that of an independent program") {}

    void add_options(CLI::App& command) override {
        constexpr int max_steps_compared = 1'000'000;
        options_.add_to(command);
        command
            .add_option(
                "--with", compared_.with,
                "a fluid: openmm, lammps, any engine by command:'./engine {input} {output}', or the files of one by "
                "files:DIR; few bodies: gsl, adaptive Runge-Kutta of order 8")
            ->required()
            ->type_name("PROGRAM");
        command.add_option("--platform", compared_.platform, "of OpenMM: Reference, CPU, OpenCL; Reference by default")
            ->type_name("PLATFORM");
        command.add_option("--steps", compared_.steps, "length of the trajectories, 1000 by default")
            ->type_name("N")
            ->check(CLI::Range(0, max_steps_compared));
        command
            .add_option("--frames", compared_.frames,
                        "steps at which trajectories are judged, 1,10,100,200,500,1000 by default")
            ->type_name("N,...")
            ->delimiter(',')
            ->check(CLI::Range(1, max_steps_compared));
        command
            .add_option(
                "--parts", compared_.parts,
                "what to compare of point,trajectory,averages,speed; all by default, of an engine all but speed")
            ->type_name("PART,...")
            ->delimiter(',')
            ->check(CLI::IsMember(crosscheck_parts()));
        command
            .add_option("--timeout", compared_.timeout,
                        "wall time after which an engine is stopped, as in 90s, 30min or 2h; 1h by default")
            ->type_name("TIME");
        command.add_option("--out", out_, "write the comparison into this directory too")->type_name("DIR");
    }

    void run() override {
        if (is_engine(compared_.with)) {
            check_engine_options(compared_);
            Diagnostics diagnostics;
            const Deck deck = options_.load(diagnostics);
            require_fluid(deck, fmt::format("{} is a few-body deck: an engine is judged by a fluid", deck.path));
            judge_engine(deck, options_.checked(deck, diagnostics), options_, compared_, out_);
            return;
        }
        static const std::vector<std::string> programs{"gsl", "lammps", "openmm"};
        if (std::find(programs.begin(), programs.end(), compared_.with) == programs.end()) {
            throw InputError(fmt::format(
                "unknown program '{}' to compare with, allowed: {}, command:'./engine {{input}} {{output}}', files:DIR",
                compared_.with, fmt::join(programs, ", ")));
        }
        check_compare_options(compared_);
        if (!out_.empty()) {
            const std::string name = "compare-" + compared_.with;
            require_no_outputs(out_, {name + ".json", name + ".csv", name + "-trajectory.csv", name + "-rdf.csv"},
                               options_.force, "Nothing was compared");
        }
        Diagnostics diagnostics;
        const Deck deck = options_.load(diagnostics);
        if (compared_.with == "gsl") {
            compare_bodies(deck, options_, out_);
            return;
        }
        require_fluid(deck, fmt::format("{} is a few-body deck, which '{}' does not take; '--with gsl' compares it",
                                        deck.path, compared_.with));
        compare_fluid(deck, options_.checked(deck, diagnostics), options_, compared_, out_);
    }

  private:
    DeckOptions options_;
    CrosscheckOptions compared_;
    std::string out_;
};

}  // namespace

std::shared_ptr<Command> compare_command() {
    return std::make_shared<CompareCommand>();
}

}  // namespace ljmd
