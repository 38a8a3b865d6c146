#include "cli/judge/judge_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "cli/progress.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "deck/fluid.hpp"
#include "io/files/file_system.hpp"
#include "io/files/scratch_directory.hpp"
#include "io/files/shown_path.hpp"
#include "io/tables/json_file.hpp"
#include "judge/answer_reader.hpp"
#include "judge/engine_command.hpp"
#include "judge/engine_speed.hpp"
#include "judge/judge.hpp"
#include "judge/own_run.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/units.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"
#include "run/run_record.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

const std::string by_command = "command:";
const std::string by_files = "files:";
constexpr const char* exchange_folder = "exchange";
constexpr const char* problem_folder = "problem";
constexpr const char* answer_folder = "answer";
constexpr const char* log_name = "engine.log";
constexpr const char* judgement_file = "judge.json";
const std::vector<std::string> problem_files{ExchangeFiles::problem, ExchangeFiles::start,
                                             ExchangeFiles::start_for_lammps};

double seconds_of(const std::string& timeout) {
    const auto seconds = parse_wall_time(timeout);
    if (!seconds) {
        throw InputError(fmt::format(
            "--timeout: '{}' is no wall time; allowed: a number > 0 with s, min, h or d, as in 90s or 2h", timeout));
    }
    return *seconds;
}

/// The speed is measured if it is asked for by name: the engine runs six times more.
bool wants_speed(const CrosscheckOptions& compared) {
    return std::ranges::find(compared.parts, "speed") != compared.parts.end();
}

/// Take off the velocity of the centre of mass, which a stage before may have left; the atoms have equal masses.
void bring_to_rest(Fluid& fluid) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& v : fluid.velocities) {
        mean += v / static_cast<double>(fluid.velocities.size());
    }
    for (Vec3& v : fluid.velocities) {
        v -= mean;
    }
}

/// Refuse a directory that a judgement cannot be written to. Of what is in it nothing is removed but the answer of an
/// earlier engine, which lies beside its problem. @throws OutputRefused
void check_out(const fs::path& out, bool force) {
    const std::string consequence = "Nothing was judged";
    const fs::path exchange(exchange_folder);
    std::vector<std::string> names{judgement_file, exchange / log_name};
    std::ranges::transform(problem_files, std::back_inserter(names),
                           [&](const std::string& name) { return (exchange / problem_folder / name).string(); });
    require_no_outputs(out, names, force, consequence);
    const bool is_ours = files::is_taken(out / exchange / problem_folder / ExchangeFiles::problem);
    for (const fs::path& folder : {exchange, exchange / problem_folder, exchange / answer_folder}) {
        const fs::file_type type = files::type_of(out / folder);
        const bool is_foreign = folder == exchange / answer_folder && !is_ours;
        if (type != fs::file_type::not_found && (type != fs::file_type::directory || is_foreign)) {
            throw OutputRefused(fmt::format("{} is in the way: files of an engine are to be written there, and it is "
                                            "no folder of an earlier comparison. {}.",
                                            (out / folder).string(), consequence),
                                {another_directory});
        }
    }
}

/// One judgement, from the problem to the verdict.
class Session {
  public:
    Session(const Deck& deck, CheckedRun fluid, const DeckOptions& options, const CrosscheckOptions& compared,
            std::string out)
        : deck_(deck),
          fluid_(std::move(fluid)),
          options_(options),
          compared_(compared),
          out_(std::move(out)),
          progress_(fluid_.atoms(), steps_before_crosscheck(deck), options.quiet),
          own_{fluid_spec(deck), fluid_.execution, deck.neighbors().method} {}

    void by_command_line(const std::string& command) {
        std::optional<ScratchDirectory> scratch;
        const fs::path place = out_.empty() ? scratch.emplace().path() : files::absolute(out_) / exchange_folder;
        const fs::path input = place / problem_folder;
        const fs::path output = place / answer_folder;
        const std::string line = engine_command(command, input, output);
        const Problem problem = problem_with(moment());
        install_stop_handlers();
        make_directory(input);
        write_problem(problem, input, options_.force);
        files::try_to_remove_all(output);  // with --force: of an earlier engine
        files::remove(place / log_name);   // no child process follows a link
        make_directory(output);
        say("running the engine");
        line_ = command;
        finish(problem, scratch ? answer_of_engine(line, place, problem, {{output, "{output}"}, {input, "{input}"}},
                                                   "\n  --out DIR keeps the files of the engine")
                                : answer_of_engine(line, place, problem,
                                                   {{place, (fs::path(out_) / exchange_folder).string()}}, ""));
    }

    void by_directory(const fs::path& directory) {
        if (!files::exists(directory / ExchangeFiles::problem)) {
            hand_out(directory);
            return;
        }
        const FluidSpec& spec = own_.spec;
        const Problem problem = problem_with(read_start(directory, spec.potential, spec.has_tail()));
        if (json_text(directory / ExchangeFiles::problem) != problem_json(problem)) {
            throw InputError(fmt::format(
                "{} is the problem of another deck, of other options or of another version of ljmd: give the command "
                "that wrote it, or take another directory",
                (directory / ExchangeFiles::problem).string()));
        }
        if (!has_answer(directory)) {
            throw DataError(
                fmt::format("there is no answer yet in {0}: {1}", directory.string(), what_to_do(directory)));
        }
        finish(problem, read_answer(directory, problem));
    }

  private:
    /// What the engine answers.
    /// @param names  what the user calls the directories, in messages and warnings
    /// @param hint   ends a message
    [[nodiscard]] Answer answer_of_engine(const std::string& line, const fs::path& place, const Problem& problem,
                                          const std::vector<std::pair<fs::path, std::string>>& names,
                                          const std::string& hint) const {
        const auto shown = [&](std::string text) {
            for (const auto& [path, name] : names) {
                text = shown_as(std::move(text), path, name);
            }
            return text;
        };
        try {
            const fs::path output = place / answer_folder;
            run_engine(line, place / log_name, {.seconds = seconds_of(compared_.timeout), .folder = output},
                       until_signal());
            if (!has_answer(output)) {
                throw DataError(
                    "the engine has written none of point.json, point.xyz, frames.xyz and thermo.csv into {output}: "
                    "there is nothing to judge");
            }
            Answer answer = read_answer(output, problem);
            for (std::string& warning : answer.warnings) {
                warning = shown(std::move(warning));
            }
            return answer;
        } catch (const DataError& error) {
            throw DataError(shown(error.what()) + hint);
        }
    }

    [[nodiscard]] Replacing allowed() const { return {.force = options_.force, .instead = another_directory}; }

    [[nodiscard]] Problem problem_with(Fluid start) const {
        Problem problem = problem_of(deck_, std::move(start), compared_);
        problem.deck_hash = deck_hash(deck_);
        return problem;
    }

    /// The moment that is judged, after the stages of the deck before it.
    Fluid moment() {
        FluidSystem simulation = make_fluid(fluid_spec(deck_, std::move(fluid_.start.value())), fluid_.execution,
                                            [&](const std::string& text) { progress_.warning(text); });
        Fluid fluid = run_before_crosscheck(deck_, simulation, progress_);
        progress_.clear_line();
        if (freedom_of(deck_.stages()[first_sampled(deck_.stages())], std::ssize(fluid.masses)) <
            3 * std::ssize(fluid.masses)) {
            bring_to_rest(fluid);
        }
        return fluid;
    }

    [[nodiscard]] static std::string what_to_do(const fs::path& directory) {
        return fmt::format(
            "put any of point.json, point.xyz, frames.xyz and thermo.csv into {}, as {} says under 'wanted', and give "
            "the "
            "same command again",
            directory.string(), (directory / ExchangeFiles::problem).string());
    }

    void hand_out(const fs::path& directory) {
        if (has_answer(directory)) {
            throw InputError(fmt::format(
                "{} has files of an engine, but no {}: it is not known what they answer. Nothing was written.",
                directory.string(), ExchangeFiles::problem));
        }
        require_no_outputs(directory, problem_files, options_.force, "Nothing was written");
        const Problem problem = problem_with(moment());
        make_directory(directory);
        write_problem(problem, directory, options_.force);
        if (options_.json) {
            print_result(to_json({{"with", compared_.with},
                                  {"problem", directory.string()},
                                  {"checks", Data::list()},
                                  {"passed", nullptr}}) +
                         "\n");
            return;
        }
        print_result(fmt::format("the problem is in {0}: {1}, {2}, {3}\nnothing was judged: {4}\n", directory.string(),
                                 ExchangeFiles::problem, ExchangeFiles::start, ExchangeFiles::start_for_lammps,
                                 what_to_do(directory)));
    }

    void say(const std::string& text) {
        if (!options_.quiet) {
            progress_.clear_line();
            print_message(text + "\n");
        }
    }

    /// The speed of the engine's run beside that of ljmd, each in new directories and by the same clock.
    [[nodiscard]] std::optional<EngineSpeed> speed_of(const Problem& problem) const {
        using Clock = std::chrono::steady_clock;
        const auto timed = [](const auto& work) {
            const auto begin = Clock::now();
            work();
            return std::chrono::duration<double>(Clock::now() - begin).count();
        };
        Problem part = problem;
        part.parts = {"averages"};
        part.frames = {0};
        part.trajectory_steps = 0;
        const auto ours = [&](Index steps) {
            part.stage.steps = steps;
            return timed([&] { static_cast<void>(own_run(part, own_.spec, own_.execution, until_signal())); });
        };
        const auto theirs = [&](Index steps) {
            part.stage.steps = steps;
            const ScratchDirectory scratch;
            const fs::path input = scratch.path() / problem_folder;
            const fs::path output = scratch.path() / answer_folder;
            make_directory(input);
            make_directory(output);
            write_problem(part, input);
            return timed([&] {
                run_engine(engine_command(line_, input, output), scratch.path() / log_name,
                           {.seconds = seconds_of(compared_.timeout), .folder = output}, until_signal());
            });
        };
        return compare_speed(ours, theirs, problem.stage.steps, problem.thermo_every);
    }

    void finish(const Problem& problem, const Answer& answer) {
        Judgement found = judge(
            problem, answer, own_, [&](const std::string& text) { say(text); }, until_signal());
        if (wants_speed(compared_)) {
            say("measuring speeds");
            found.speed = problem.stage.steps >= 2 * problem.thermo_every ? speed_of(problem) : std::nullopt;
            if (!found.speed) {
                found.not_judged.emplace_back("speed: the run is too short to be told from its start-up");
            }
        }
        const std::string json = judgement_json(found, deck_, compared_.with) + "\n";
        if (!out_.empty()) {
            make_directory(out_);
            write_output(fs::path(out_) / judgement_file, allowed(), json);
        }
        for (const std::string& text : found.warnings) {
            warn(text);
        }
        print_result(options_.json ? json : judgement_table(found, deck_));
        if (!found.passed()) {
            throw PhysicsError(fmt::format("ljmd and {} differ: {} of {} checks failed", found.engine, found.failures(),
                                           found.checks.size()));
        }
        if (!found.own_failure.empty()) {
            throw PhysicsError(fmt::format(
                "ljmd's own run of {} failed, so that averages cannot be judged; the engine is not at fault: {}",
                deck_.path, found.own_failure));
        }
        if (found.checks.empty() && !found.speed) {
            throw DataError("nothing was judged: the answer has nothing that the problem asks for");
        }
    }

    const Deck& deck_;
    CheckedRun fluid_;
    const DeckOptions& options_;
    const CrosscheckOptions& compared_;
    std::string out_;
    Progress progress_;
    OwnSide own_;
    std::string line_;  ///< of the engine, with {input} and {output}
};

}  // namespace

bool is_engine(const std::string& with) {
    return with.starts_with(by_command) || with.starts_with(by_files);
}

void check_engine_options(const CrosscheckOptions& compared) {
    const CrosscheckOptions usual{.with = compared.with};
    if (compared.platform != usual.platform) {
        throw InputError("--platform is OpenMM's: an engine has none");
    }
    if (wants_speed(compared) && compared.with.starts_with(by_files)) {
        throw InputError("--parts: files by hand have no speed; allowed: point, trajectory, averages");
    }
    if (!compared.wants("trajectory") && (compared.steps != usual.steps || compared.frames != usual.frames)) {
        throw InputError("--steps and --frames are those of the trajectory, which --parts leaves out");
    }
    static_cast<void>(seconds_of(compared.timeout));
    if (compared.with.starts_with(by_command)) {
        static_cast<void>(engine_command(compared.with.substr(by_command.size()), "input", "output"));
    } else if (compared.with.size() == by_files.size()) {
        throw InputError("--with files: the name of the directory is missing, as in --with files:answers");
    } else if (compared.timeout != usual.timeout) {
        throw InputError("--timeout is of an engine that is run, --with command:...");
    }
}

void judge_engine(const Deck& deck, CheckedRun fluid, const DeckOptions& options, const CrosscheckOptions& compared,
                  const std::string& out) {
    if (!out.empty()) {
        check_out(out, options.force);
    }
    Session session(deck, std::move(fluid), options, compared, out);
    if (compared.with.starts_with(by_command)) {
        session.by_command_line(compared.with.substr(by_command.size()));
    } else {
        session.by_directory(compared.with.substr(by_files.size()));
    }
}

}  // namespace ljmd
