#include "analyze/trajectory_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analyze/deck_against_frames.hpp"
#include "core/text.hpp"
#include "deck/deck_execution.hpp"
#include "deck/fluid.hpp"
#include "execution/threads.hpp"
#include "io/formats/frame_unwrapper.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/box_for_cutoff.hpp"
#include "observables/interface/film.hpp"
#include "observables/transport/centre_frame.hpp"
#include "observables/transport/finite_size.hpp"
#include "run/results.hpp"

namespace ljmd {

namespace {

DeckClaims claims_of(const AnalyzedTrajectory& trajectory) {
    if (trajectory.deck == nullptr) {
        return {};
    }
    const Box box(trajectory.summary.edges);
    return {sampled_ensemble(trajectory.deck->stages()),
            sampled_run(*trajectory.deck, trajectory.summary.atoms, box).held_temperature};
}

/// One pass over a trajectory.
class Pass {
  public:
    Pass(const AnalyzedTrajectory& trajectory, const std::vector<FrameAnalysis>& analyses, const FrameRead& frame_read)
        : trajectory_(trajectory),
          analyses_(analyses),
          frame_read_(frame_read),
          averages_(trajectory.summary.atoms, claims_of(trajectory).ensemble),
          tail_(trajectory.thermo ? fluid_spec(*trajectory.deck).interaction().tail : TailCorrection()) {}

    void run() {
        each_frame(
            trajectory_, [this](std::size_t k, Configuration&& frame) { take(k, std::move(frame)); }, frame_read_);
    }

    /// Averages of energies and pressures, if requested; else only of the temperature, if there are velocities.
    [[nodiscard]] std::vector<ObservableAverage> averages() const {
        std::vector<ObservableAverage> found = averages_.averages();
        std::erase_if(found, [&](const ObservableAverage& average) {
            return !trajectory_.thermo && (average.name != "temperature" || !trajectory_.summary.has_velocities);
        });
        return found;
    }

    [[nodiscard]] const EnergyFluctuations& energies() const { return energies_; }

  private:
    void take(std::size_t k, Configuration configuration) {
        if (!trajectory_.summary.box_changes) {
            configuration.edges = trajectory_.summary.edges;
        }
        if (trajectory_.summary.positions.positions == Positions::wrapped) {
            unwrapper_.unwrap(configuration);
        }
        const std::optional<std::size_t> part = trajectory_.selection.parts[k];
        if (!part) {
            return;
        }
        if (part != part_) {
            for (const FrameAnalysis& each : analyses_) {
                each.analysis->interrupt();
            }
            part_ = part;
        }
        const Index number = trajectory_.selection.numbers[k];
        const auto is_due = [&](const FrameAnalysis& each) { return each.analysis->due(number); };
        if (trajectory_.thermo || std::ranges::any_of(analyses_, is_due)) {
            sample(number, k, configuration);
        }
    }

    [[nodiscard]] Box box_of(const Configuration& configuration) const {
        const Box box(configuration.edges);
        return trajectory_.deck == nullptr ? box : box_for_cutoff(box, trajectory_.deck->potential().radius);
    }

    void sample(Index number, std::size_t k, const Configuration& configuration) {
        State state(trajectory_.summary.atoms, box_of(configuration), trajectory_.execution);
        place_configuration(state, configuration);
        state.time = configuration.time.value_or(0.0);
        state.step = configuration.step.value_or(0);  // random numbers depend on it
        Evaluation evaluation;
        if (trajectory_.thermo || std::ranges::any_of(analyses_, [&](const FrameAnalysis& each) {
                return each.analysis->due(number) && each.analysis->needs_energy();
            })) {
            evaluation = evaluate(state, k);
        }
        const Thermodynamics found = thermodynamics(state, evaluation, tail_);
        averages_.add(found);
        energies_.add(found);
        for (const FrameAnalysis& each : analyses_) {
            if (each.analysis->due(number)) {
                each.analysis->sample(state, evaluation);
            }
        }
    }

    /// With a new force field for each frame, because a neighbour list does not last from frame to frame.
    [[nodiscard]] Evaluation evaluate(State& state, std::size_t k) const {
        const Evaluation evaluation = make_force_field(fluid_spec(*trajectory_.deck), state.execution())
                                          .evaluate(state, Request::forces_and_energy);
        if (!std::isfinite(evaluation.potential_energy)) {
            throw DataError(fmt::format("{}: frame {}: atoms overlap, the forces between them are not finite",
                                        trajectory_.path.string(), k + 1));
        }
        return evaluation;
    }

    const AnalyzedTrajectory& trajectory_;
    const std::vector<FrameAnalysis>& analyses_;
    const FrameRead& frame_read_;
    RunAverages averages_;
    EnergyFluctuations energies_;
    TailCorrection tail_;  ///< for energies and pressures, if requested
    FrameUnwrapper unwrapper_;
    std::optional<std::size_t> part_;  ///< of the last frame
};

/// How positions were treated; null if no displacement was measured.
Data positions_data(const AnalyzedTrajectory& trajectory, const TrajectoryResult& result) {
    const PositionReading& reading = trajectory.summary.positions;
    if (!result.used_displacements) {
        return nullptr;
    }
    return {{"taken_as", reading.positions == Positions::wrapped ? "wrapped" : "unwrapped"},
            {"told_by", reading.told_by},
            {"largest_step", trajectory.summary.motion.largest_step}};
}

std::string si_box(const Vec3& edges, const std::optional<SubstanceUnits>& units) {
    if (!units) {
        return "";
    }
    const Vec3 nm = units->nanometre() * edges;
    return fmt::format(" ({:.6g} x {:.6g} x {:.6g} nm^3)", nm[0], nm[1], nm[2]);
}

}  // namespace

AnalyzedTrajectory trajectory_to_analyze(const std::filesystem::path& path, const Deck* deck, bool is_run, bool thermo,
                                         const FrameOptions& options, const FrameRead& frame_read) {
    AnalyzedTrajectory trajectory{
        .path = path,
        .deck = deck,
        .summary = {},
        .selection = {},
        .group = options.group,
        .thermo = thermo,
        .xyz_comment = options.xyz_comment,
        .execution = Execution(deck != nullptr ? execution_options(*deck)
                                               : ExecutionOptions{.threads = default_thread_count()})};
    trajectory.summary =
        summarize(path, trajectory.units(), options.group, options.positions, options.xyz_comment, frame_read);
    std::optional<double> time_step = options.time_step;
    if (!time_step && deck != nullptr && !trajectory.summary.steps.empty()) {
        time_step = deck->stages()[first_sampled(deck->stages())].time_step;
    }
    trajectory.selection =
        select_frames(trajectory.summary, time_step, is_run ? &deck->stages() : nullptr, options.from);
    if (thermo) {
        check_thermo(deck, trajectory.summary, trajectory.selection);
    }
    return trajectory;
}

void each_frame(const AnalyzedTrajectory& trajectory,
                const std::function<void(std::size_t number, Configuration&& frame)>& take,
                const FrameRead& frame_read) {
    const auto reader = open_trajectory(trajectory.path, trajectory.units(), trajectory.group, trajectory.xyz_comment);
    const auto frames = static_cast<std::size_t>(trajectory.summary.frames);
    Frame frame;
    for (std::size_t k = 0; k < frames; ++k) {
        if (!reader->next(frame) || std::ssize(frame.configuration.positions) != trajectory.summary.atoms) {
            throw DataError(fmt::format("{} has changed while it was read", trajectory.path.string()));
        }
        take(k, std::move(frame.configuration));
        if (frame_read) {
            frame_read();
        }
    }
}

TrajectoryResult analyze_trajectory(const AnalyzedTrajectory& trajectory, const std::vector<FrameAnalysis>& analyses,
                                    const FrameRead& frame_read) {
    Pass pass(trajectory, analyses, frame_read);
    pass.run();
    TrajectoryResult result;
    result.warnings = trajectory.summary.warnings;
    result.used_displacements =
        std::ranges::any_of(analyses, [](const auto& each) { return each.method.needs.unwrapped_positions; });
    if (result.used_displacements && !trajectory.summary.positions.doubt.empty()) {
        result.warnings.push_back(trajectory.summary.positions.doubt);
    }
    result.averages = pass.averages();
    for (const auto& [method, analysis] : analyses) {
        std::vector<DataTable> tables = analysis->tables();
        std::vector<ObservableAverage> averages = analysis->observables();
        if (tables.empty() && averages.empty()) {
            result.warnings.push_back(
                fmt::format("{} has found nothing: {} frames are too few for it", method.name, analysis->samples()));
        }
        std::ranges::move(tables, std::back_inserter(result.tables));
        std::ranges::move(averages, std::back_inserter(result.averages));
    }
    mark_slow_exchange(result.averages);
    if (trajectory.deck != nullptr && !trajectory.deck->given.external.empty()) {
        withdraw_diffusion(result.averages,
                           fmt::format("frames do not tell whether the external force {} differed between atoms: {}",
                                       in_quotes(trajectory.deck->given.external), no_frame_of_diffusion));
    }
    if (const auto infinite = diffusion_in_infinite_system(result.averages, Box(trajectory.summary.edges))) {
        result.averages.push_back(*infinite);
    }
    withdraw_contradicted(result.averages, claims_of(trajectory), pass.energies(), trajectory.summary.box_changes);
    if (const std::string unsure = unsure_of(result.averages); !unsure.empty()) {
        result.warnings.push_back(
            fmt::format("the trajectory is too short for the error bars of {}: they are guesses", unsure));
    }
    return result;
}

Document trajectory_document(const AnalyzedTrajectory& trajectory, const TrajectoryResult& result) {
    const TrajectorySummary& summary = trajectory.summary;
    const Vec3& edges = summary.edges;
    std::string text = fmt::format("{}\n{} frames of {} atoms, box {:.6g} x {:.6g} x {:.6g} sigma^3{}{}\n{} measured",
                                   trajectory.path.string(), summary.frames, summary.atoms, edges[0], edges[1],
                                   edges[2], si_box(edges, trajectory.units()), summary.box_changes ? " at first" : "",
                                   trajectory.selection.used);
    if (trajectory.selection.spacing) {
        text += fmt::format(", {:.6g} tau apart", *trajectory.selection.spacing);
    }
    if (result.used_displacements) {
        text += "\n" + description(summary.positions, summary.motion);
    }
    text += "\n\n";
    if (!result.averages.empty()) {
        text += observables_table(result.averages, trajectory.units());
        text += samples_footnote();
    }
    return {{{"trajectory", trajectory.path.string()},
             {"atoms", summary.atoms},
             {"box_edges", Data::list({edges[0], edges[1], edges[2]})},
             {"frames", summary.frames},
             {"frames_used", trajectory.selection.used},
             {"spacing", trajectory.selection.spacing},
             {"positions", positions_data(trajectory, result)},
             {"observables", observables_data(result.averages, trajectory.units())},
             {"warnings", result.warnings}},
            text};
}

}  // namespace ljmd
