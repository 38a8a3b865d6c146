#include "judge/judge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compare/point_comparison.hpp"
#include "judge/few_digits.hpp"
#include "judge/frame_judgement.hpp"
#include "judge/own_run.hpp"
#include "judge/point_judgement.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

/// Relative differences below this are none, for a diagnosis.
constexpr double default_noise = 1e-10;
constexpr double noise_of_mixed_precision = 1e-4;

/// Numbers of a table may have been through text of ten digits.
constexpr double digits_of_table = 1e-9;

/// The judgement of one answer, part by part.
class Session {
  public:
    Session(const Problem& problem, const Answer& answer, const OwnSide& own,
            const std::function<void(const std::string&)>& say, const Interruption& interruption)
        : problem_(problem),
          answer_(answer),
          own_(own),
          say_(say),
          interruption_(interruption),
          is_mixed_(own.execution.precision() == Precision::mixed),
          situation_(situation_of(problem.fluid, problem.stage.time_step)),
          agreement_(is_mixed_ ? single_agreement(situation_) : engine_agreement(situation_)),
          expected_(expected_point(problem.fluid, point_of(problem.fluid, *force_field(), own.execution))) {}

    void point() {
        const PointAnswer& point = answer_.point;
        if (point.is_empty()) {
            leave_out("point", "there is no point.json, and no frame with forces beside it");
            return;
        }
        if (!point.potential_energy) leave_out("potential energy", "missing in point.json");
        if (!point.virial) leave_out("virial", "missing in point.json");
        if (point.forces.empty()) leave_out("forces of the start", "missing in point.json, and there is no point.xyz");
        append(check_point(expected_, point, agreement_));
        diagnose(point, "");
        few_digits(check_point(expected_, point, single_agreement(situation_)), point.forces, "point.json");
    }

    void trajectory() {
        JudgedTrajectory trajectory{problem_.fluid.edges, problem_.stage.time_step, {}};
        std::vector<Index> missing;
        for (const Index step : problem_.frames) {
            const auto found = std::ranges::find(answer_.frames, step,
                                                 [](const Frame& frame) { return frame.configuration.step.value(); });
            if (found == answer_.frames.end()) {
                missing.push_back(step);
            } else {
                trajectory.frames.push_back({.step = step,
                                             .positions = found->configuration.positions,
                                             .velocities = found->configuration.velocities,
                                             .forces = found->forces});
            }
        }
        if (trajectory.frames.empty()) {
            leave_out("trajectory", answer_.frames.empty() ? "there are no frames"
                                                           : fmt::format("there is no frame of one of the steps {}",
                                                                         fmt::join(problem_.frames, ", ")));
            return;
        }
        if (!missing.empty()) {
            leave_out(fmt::format("trajectory at step{} {}", missing.size() == 1 ? "" : "s", fmt::join(missing, ", ")),
                      "no frame");
        }
        const auto lacks = [&](auto member) {
            return std::ranges::any_of(trajectory.frames,
                                       [&](const JudgedFrame& frame) { return (frame.*member).empty(); });
        };
        if (lacks(&JudgedFrame::velocities))
            leave_out("kinetic energies of the trajectory", "frames have no velocities");
        if (lacks(&JudgedFrame::forces)) leave_out("forces along the trajectory", "frames have no forces");
        say_(fmt::format("following the trajectory over {} steps", trajectory.frames.back().step));
        follow(problem_.fluid, *force_field(), own_.execution, trajectory);
        append(check_trajectory(trajectory, problem_.frames, agreement_));
        result_.time_step = trajectory.time_step;
        for (const JudgedFrame& frame : trajectory.frames) {
            result_.trajectory.push_back({.step = frame.step,
                                          .distance = largest_distance(frame, trajectory.edges),
                                          .allowed = limit_at(agreement_.positions, frame.step)});
            if (!frame.forces.empty()) {
                result_.trajectory.back().force_difference = largest_force_difference(frame);
            }
        }
        for (const std::string& words :
             diagnose_trajectory(trajectory, problem_.fluid, *force_field(), own_.execution, agreement_)) {
            note(words);
        }
        const JudgedFrame& first = trajectory.frames.front();
        const bool told = !answer_.point.forces.empty() && !result_.diagnoses.empty();  // of the point, most likely
        if (first.step == 0 && !told && !first.forces.empty()) {
            diagnose({.forces = first.forces}, "frame of step 0: ");
        }
        std::vector<Vec3> numbers;
        for (const JudgedFrame& frame : trajectory.frames) {
            for (const auto* vectors : {&frame.velocities, &frame.forces}) {
                numbers.insert(numbers.end(), vectors->begin(), vectors->end());
            }
        }
        few_digits(check_trajectory(trajectory, problem_.frames, single_agreement(situation_)), numbers, "the frames");
    }

    void run() {
        if (!answer_.thermo) {
            leave_out("averages", "there is no thermo.csv");
            return;
        }
        ThermoAnswer table = *answer_.thermo;
        const RunConditions conditions = conditions_of_run();
        take_rows(judge_temperatures(table, expected_.atoms, conditions.freedom,
                                     is_mixed_ ? noise_of_mixed_precision : digits_of_table));
        if (table.kinetic_energy.empty()) {
            for (const double temperature : table.temperature) {
                table.kinetic_energy.push_back(0.5 * static_cast<double>(conditions.freedom) * temperature);
            }
        }
        if (table.steps.front() == 0) {
            first_row(table);
        }
        rows(table);
        RunSamples theirs = samples_after_start(table);
        if (table.steps.back() == 0) {
            leave_out("averages", "thermo.csv has no row after step 0");
            return;
        }
        if (table.steps.back() < problem_.stage.steps) {
            result_.warnings.push_back(fmt::format("thermo.csv ends with step {}, the run has {} steps",
                                                   table.steps.back(), problem_.stage.steps));
        }
        if (conditions.same_motion && std::ranges::none_of(table.steps, [&](Index step) {
                return step > 0 && step % problem_.thermo_every == 0;
            })) {
            leave_out("averages", fmt::format("no row of thermo.csv is at a multiple of thermo_every, {}: its steps "
                                              "begin with {}",
                                              problem_.thermo_every, table.steps.front()));
            return;
        }
        say_(fmt::format("sampling the same run of {} steps in ljmd", problem_.stage.steps));
        RunSamples ours;
        try {
            ours = own_run(problem_, own_.spec, own_.execution, interruption_);
        } catch (const PhysicsError& error) {
            result_.own_failure = error.what();
            leave_out("averages", fmt::format("ljmd's own run of the deck failed: {}", error.what()));
            return;
        }
        if (conditions.same_motion) {
            keep_common_rows(ours, problem_.thermo_every, theirs, table.steps);
        }
        RunJudgement judged = judge_run(conditions, ours, theirs);
        append(judged.checks);
        result_.means = std::move(judged.means);
        for (const std::string& words : judged.diagnoses) note(words);
        result_.not_judged.insert(result_.not_judged.end(), judged.not_judged.begin(), judged.not_judged.end());
    }

    Judgement take() {
        for (const Loss& loss : answer_.losses) {
            result_.checks.push_back({loss.check, std::nan(""), 0.0});
            note(loss.words);
        }
        const PairForceField field = make_force_field(own_.spec, own_.execution);
        const bool kernel = own_.spec.neighbors.keeps_list();
        result_.atoms = expected_.atoms;
        result_.steps_before = problem_.steps_before;
        result_.engine = answer_.engine.empty() ? "the engine" : answer_.engine;
        result_.path = fmt::format("{}, {}, {} precision, {} thread{}", own_.search,
                                   kernel ? std::string(name(field.simd())) : "scalar", name(field.precision()),
                                   own_.execution.threads(), own_.execution.threads() == 1 ? "" : "s");
        result_.warnings.insert(result_.warnings.begin(), answer_.warnings.begin(), answer_.warnings.end());
        return std::move(result_);
    }

  private:
    [[nodiscard]] std::unique_ptr<ForceField> force_field() const {
        return std::make_unique<PairForceField>(make_force_field(own_.spec, own_.execution));
    }

    void append(const std::vector<Check>& more) {
        result_.checks.insert(result_.checks.end(), more.begin(), more.end());
    }

    void leave_out(const std::string& what, const std::string& why) {
        result_.not_judged.push_back(fmt::format("{}: {}", what, why));
    }

    void note(const std::string& words) {
        if (std::ranges::find(result_.diagnoses, words) == result_.diagnoses.end()) {
            result_.diagnoses.push_back(words);
        }
    }

    void diagnose(const PointAnswer& point, const std::string& where) {
        const double noise = is_mixed_ ? noise_of_mixed_precision : default_noise;
        for (const std::string& words : diagnose_point(problem_.fluid, expected_, point, noise)) {
            note(where + words);
        }
    }

    /// @param wide     the same checks as those that were appended last, by the tolerances of single precision
    /// @param numbers  that were written, where their digits show
    void few_digits(const std::vector<Check>& wide, const std::vector<Vec3>& numbers, const char* where) {
        const auto begin = result_.checks.end() - std::ssize(wide);
        const bool some = std::any_of(begin, result_.checks.end(), [](const Check& check) { return !check.passed(); });
        const bool all = std::ranges::all_of(wide, [](const Check& check) { return check.passed(); });
        if (!some || !all || !result_.diagnoses.empty()) {
            return;
        }
        const auto digits = digits_of(numbers);
        const bool is_single = digits == "single precision";
        note(digits && !is_single
                 ? fmt::format("few digits: numbers of {} have {}; 17 significant digits are exact", where, *digits)
                 : fmt::format(
                       "single precision: all differences are as small as those of single precision{}: the engine "
                       "computes in it, or numbers lose digits on the way; with --precision mixed it is judged by "
                       "that",
                       is_single ? ", and numbers have its digits" : ""));
    }

    [[nodiscard]] RunConditions conditions_of_run() const {
        const Stage& stage = problem_.stage;
        RunConditions conditions{.atoms = expected_.atoms,
                                 .time_step = stage.time_step,
                                 .freedom = answer_.degrees_of_freedom.value_or(freedom_of(stage, expected_.atoms)),
                                 .our_freedom = freedom_of(stage, expected_.atoms)};
        conditions.squared_frequency = expected_.squared_frequency();
        conditions.same_motion = is_verlet_at_constant_energy();
        conditions.same_precision = !is_mixed_;
        conditions.digits = digits_of_table;
        if (stage.thermostat) conditions.temperature = stage.temperature;
        conditions.pressure = held_pressure(stage);
        return conditions;
    }

    /// The row of step 0 is of the start, whose numbers are known to the last digits.
    void first_row(const ThermoAnswer& table) {
        const auto first = [](const std::vector<double>& column) {
            return column.empty() ? std::nullopt : std::optional(column.front());
        };
        const PointAnswer row{.potential_energy = first(table.potential_energy),
                              .kinetic_energy = first(table.kinetic_energy),
                              .pressure = first(table.pressure)};
        Agreement of_table = agreement_;
        for (double* limit : {&of_table.energy, &of_table.pressure}) {
            *limit = std::max(*limit, digits_of_table);
        }
        for (Check check : check_point(expected_, row, of_table)) {
            check.name = "thermo.csv, step 0: " + check.name;
            result_.checks.push_back(check);
        }
        diagnose(row, "thermo.csv, step 0: ");
        const double ours = expected_.kinetic_energy;
        if (row.kinetic_energy && !(relative_difference(*row.kinetic_energy, ours) <= of_table.energy)) {
            for (const double side : {-1.0, 1.0}) {
                const double half = half_step_kinetic_energy(problem_.fluid, expected_.sums.forces,
                                                             0.5 * side * problem_.stage.time_step);
                if (relative_difference(*row.kinetic_energy, half) <= of_table.energy) {
                    note(
                        fmt::format("half-step velocities: the kinetic energy of thermo.csv is that of velocities half "
                                    "a time step {}",
                                    side < 0.0 ? "earlier" : "later"));
                }
            }
        }
    }

    [[nodiscard]] bool is_verlet_at_constant_energy() const {
        const Stage& stage = problem_.stage;
        return !stage.thermostat && !stage.barostat &&
               (stage.integrator.name == "velocity-verlet" || stage.integrator.name == "leapfrog");
    }

    /// Rows of a run at constant energy, while the engine's trajectory and ours are together.
    void rows(const ThermoAnswer& table) {
        const Stage& stage = problem_.stage;
        if (stage.thermostat || stage.barostat) {
            return;  // each program has its own random numbers, and its own way
        }
        if (!is_verlet_at_constant_energy()) {
            leave_out("rows of thermo.csv", "the deck's integrator is not velocity Verlet");
            return;
        }
        const auto after_start = std::ranges::upper_bound(table.steps, 0);
        const Index together = agreement_.positions.empty() ? 0 : agreement_.positions.back().step;
        if (after_start == table.steps.end() || *after_start > together) {
            leave_out("rows of thermo.csv", fmt::format("there is none from step 1 to step {}, where two programs are "
                                                        "still together",
                                                        together));
            return;
        }
        const Index last = last_compared_step(table, problem_.thermo_every, together);
        const FluidSpec& spec = own_.spec;
        const std::vector<OwnRow> ours = own_rows(problem_.fluid, spec.interaction().tail, *force_field(),
                                                  own_.execution, stage.time_step, last + 1);
        const RowConditions conditions{.atoms = expected_.atoms,
                                       .volume = expected_.volume,
                                       .thermo_every = problem_.thermo_every,
                                       .agreement = agreement_,
                                       .digits = is_mixed_ ? noise_of_mixed_precision : digits_of_table,
                                       .tail_energy = expected_.tail_energy,
                                       .tail_pressure = expected_.tail_pressure};
        const RowJudgement judged = judge_rows(table, ours, conditions);
        if (judged.has_constant_motion) {  // so that the start has only been met by chance
            std::erase_if(result_.diagnoses, [](const std::string& words) {
                return words.find("3N against 3N-3: the pressure") != std::string::npos;
            });
        }
        take_rows(judged);
    }

    void take_rows(const RowJudgement& judged) {
        append(judged.checks);
        for (const std::string& words : judged.mistakes) note(words);
        if (result_.diagnoses.empty()) {
            for (const std::string& words : judged.others) note(words);
        }
    }

    [[nodiscard]] static RunSamples samples_after_start(const ThermoAnswer& table) {
        const std::ptrdiff_t skipped = table.steps.front() == 0 ? 1 : 0;
        const auto rest = [&](const std::vector<double>& column) {
            return column.empty() ? column : std::vector<double>(column.begin() + skipped, column.end());
        };
        return {rest(table.potential_energy), rest(table.kinetic_energy), rest(table.pressure), rest(table.volume)};
    }

    const Problem& problem_;
    const Answer& answer_;
    const OwnSide& own_;
    const std::function<void(const std::string&)>& say_;
    const Interruption& interruption_;
    bool is_mixed_;
    Situation situation_;
    Agreement agreement_;
    ExpectedPoint expected_;
    Judgement result_{};
};

}  // namespace

Index Judgement::failures() const {
    return std::ranges::count_if(checks, [](const Check& check) { return !check.passed(); });
}

Problem problem_of(const Deck& deck, Fluid fluid, const CrosscheckOptions& options) {
    constexpr Index max_samples = 100'000;
    Stage stage = deck.stages()[first_sampled(deck.stages())];
    stage.total_energy.reset();
    stage.reverse = false;
    stage.until.clear();
    std::vector<Index> frames{0};
    for (const Index step : options.frames) {
        if (step <= options.steps) {
            frames.push_back(step);
        }
    }
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    const Index last = frames.back();
    const Index every = deck.sample_every() * std::max<Index>(1, stage.steps / deck.sample_every() / max_samples);
    return {.fluid = std::move(fluid),
            .stage = std::move(stage),
            .steps_before = steps_before_crosscheck(deck),
            .trajectory_steps = last,
            .frames = std::move(frames),
            .thermo_every = every,
            .parts = options.parts};
}

Judgement judge(const Problem& problem, const Answer& answer, const OwnSide& own,
                const std::function<void(const std::string&)>& say, const Interruption& interruption) {
    Session session(problem, answer, own, say, interruption);
    if (problem.wants("point")) session.point();
    if (problem.wants("trajectory")) session.trajectory();
    if (problem.wants("averages")) session.run();
    return session.take();
}

}  // namespace ljmd
