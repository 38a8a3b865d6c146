#include "python/frames.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <exception>
#include <mutex>
#include <utility>

#include "analyze/trajectory_analysis.hpp"
#include "deck/deck_system.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "python/attention.hpp"
#include "python/loaded_deck.hpp"
#include "run/recorded_run.hpp"
#include "run/results.hpp"

namespace ljmd::python {

namespace {

namespace fs = std::filesystem;

std::optional<Positions> positions_of(const std::optional<std::string>& said) {
    if (!said) {
        return std::nullopt;
    }
    if (*said != "wrapped" && *said != "unwrapped") {
        throw InputError(fmt::format("positions: '{}' is neither 'wrapped' nor 'unwrapped'", *said));
    }
    return *said == "wrapped" ? Positions::wrapped : Positions::unwrapped;
}

/// Ends the reading of frames, because Python has raised an exception.
class Stopped : public std::exception {};

/// Do work on frames without the interpreter's lock. It gets a function to call after each frame, in which Ctrl-C is
/// noticed and ends the work.
template <class Work>
void with_attention(const Work& work) {
    Attention attention{py::none(), py::none()};
    {
        const WithoutLock free;
        try {
            work([&attention] {
                if (attention.look()) {
                    throw Stopped();
                }
            });
        } catch (const Stopped&) {
        }
    }
    attention.raise();
}

/// Frames as arrays, which grow frame by frame.
struct FrameArrays {
    std::vector<double> positions;  ///< shape (frames, N, 3), as in the file
    std::vector<double> velocities;
    std::vector<double> edges;  ///< shape (frames, 3)

    static void append(std::vector<double>& to, const std::vector<Vec3>& vectors) {
        for (const Vec3& vector : vectors) {
            to.insert(to.end(), vector.data(), vector.data() + 3);
        }
    }
    void add(const Configuration& configuration) {
        append(positions, configuration.positions);
        append(velocities, configuration.velocities);
        append(edges, {configuration.edges});
    }
};

/// An array that owns the numbers, without a copy.
py::array_t<double> array_of(std::vector<double> numbers, const std::vector<py::ssize_t>& shape) {
    auto kept = std::make_unique<std::vector<double>>(std::move(numbers));
    const double* data = kept->data();
    const py::capsule owner(kept.get(), [](void* p) {
        const std::unique_ptr<std::vector<double>> gone(static_cast<std::vector<double>*>(p));
    });
    static_cast<void>(kept.release());
    return py::array_t<double>(shape, data, owner);
}

/// A trajectory that has been read once.
class FramesOfPython {
  public:
    /// @param deck  its deck, if one is known
    FramesOfPython(const fs::path& path, std::optional<Deck> deck, bool is_run, bool thermo,
                   const FrameOptions& options, const FrameRead& frame_read)
        : deck_(std::move(deck)),
          trajectory_(trajectory_to_analyze(path, deck_ ? &*deck_ : nullptr, is_run, thermo, options, frame_read)) {}

    [[nodiscard]] Data summary() const {
        const TrajectorySummary& summary = trajectory_.summary;
        return {{"path", trajectory_.path.string()},
                {"frames", summary.frames},
                {"frames_used", trajectory_.selection.used},
                {"atoms", summary.atoms},
                {"edges", Data::list({summary.edges[0], summary.edges[1], summary.edges[2]})},
                {"has_velocities", summary.has_velocities},
                {"spacing", trajectory_.selection.spacing},
                {"warnings", summary.warnings}};
    }

    [[nodiscard]] std::vector<double> times() const { return trajectory_.summary.times; }

    [[nodiscard]] std::vector<std::string> default_names() const {
        return default_analyses(trajectory_.summary, trajectory_.selection);
    }

    /// (data, text, tables). @param settings  "analysis.rdf.bins=100"
    [[nodiscard]] py::tuple analyze(const std::vector<std::string>& names,
                                    const std::vector<std::string>& settings) const {
        TrajectoryResult result;
        Document report;
        with_attention([&](const FrameRead& frame_read) {
            const std::scoped_lock turn(busy_);
            check_analysis_names(names);
            const std::vector<FrameAnalysis> analyses =
                make_frame_analyses(names, settings, trajectory_.deck, trajectory_.summary, trajectory_.selection);
            result = analyze_trajectory(trajectory_, analyses, frame_read);
            for (DataTable& table : result.tables) {
                table = with_si_columns(std::move(table), trajectory_.units());
            }
            report = trajectory_document(trajectory_, result);
        });
        return py::make_tuple(to_python(report.data), python_text(report.text), to_python(result.tables));
    }

    /// (positions, velocities or None, edges, times or None, steps or None) of all frames.
    [[nodiscard]] py::tuple arrays() const {
        const TrajectorySummary& summary = trajectory_.summary;
        FrameArrays found;
        std::vector<double> times;
        std::vector<Index> steps;
        with_attention([&](const FrameRead& frame_read) {
            const auto add = [&](std::size_t /*number*/, Configuration&& frame) {
                if (!summary.has_velocities) {
                    frame.velocities.clear();
                }
                found.add(frame);
                times.push_back(frame.time.value_or(0.0));
                steps.push_back(frame.step.value_or(0));
            };
            each_frame(trajectory_, add, frame_read);
        });
        const auto frames = static_cast<py::ssize_t>(times.size());
        const auto atoms = static_cast<py::ssize_t>(summary.atoms);
        return py::make_tuple(
            array_of(std::move(found.positions), {frames, atoms, 3}),
            summary.has_velocities ? py::object(array_of(std::move(found.velocities), {frames, atoms, 3}))
                                   : py::object(py::none()),
            array_of(std::move(found.edges), {frames, 3}),
            summary.times.empty() ? py::object(py::none()) : array_of(std::move(times), {frames}),
            summary.steps.empty() ? py::object(py::none()) : py::array_t<Index>(frames, steps.data()));
    }

  private:
    std::optional<Deck> deck_;
    AnalyzedTrajectory trajectory_;
    mutable std::mutex busy_;  ///< one analysis at a time: they share its threads
};

FrameOptions options_of(std::optional<double> from, std::optional<double> time_step, std::string group,
                        const std::optional<std::string>& positions, std::string xyz_comment) {
    return {.from = from,
            .time_step = time_step,
            .group = std::move(group),
            .positions = positions_of(positions),
            .xyz_comment = std::move(xyz_comment)};
}

std::unique_ptr<FramesOfPython> frames_of_file(const fs::path& path, const LoadedDeck* loaded, bool thermo,
                                               std::optional<double> from, std::optional<double> time_step,
                                               std::string group, const std::optional<std::string>& positions,
                                               std::string xyz_comment) {
    std::optional<Deck> deck;
    if (loaded != nullptr) {
        deck = loaded->deck;
        require_fluid(*deck, "this is a few-body deck: a trajectory of a fluid wants that of one");
    }
    const FrameOptions options = options_of(from, time_step, std::move(group), positions, std::move(xyz_comment));
    std::unique_ptr<FramesOfPython> frames;
    with_attention([&](const FrameRead& frame_read) {
        frames = std::make_unique<FramesOfPython>(path, std::move(deck), false, thermo, options, frame_read);
    });
    return frames;
}

std::unique_ptr<FramesOfPython> frames_of_run(const fs::path& directory, std::optional<double> from,
                                              const std::optional<std::string>& positions) {
    const FrameOptions options = options_of(from, std::nullopt, "", positions, "");
    Deck deck = recorded_run(directory).deck;
    require_fluid(deck, "a few-body run has no box: its trajectory is a table");
    if (!deck.trajectory) {
        throw DataError(
            fmt::format("{} has no trajectory: its deck has no 'trajectory' in [output]", directory.string()));
    }
    const fs::path path = directory / fmt::format("trajectory.{}", deck.trajectory->format);
    std::unique_ptr<FramesOfPython> frames;
    with_attention([&](const FrameRead& frame_read) {
        frames = std::make_unique<FramesOfPython>(path, std::move(deck), true, false, options, frame_read);
    });
    return frames;
}

}  // namespace

void bind_frames(py::module_& module) {
    py::class_<FramesOfPython>(module, "Frames", "A trajectory that has been read once.")
        .def("summary", [](const FramesOfPython& frames) { return to_python(frames.summary()); })
        .def("times",
             [](const FramesOfPython& frames) {
                 const std::vector<double> times = frames.times();
                 return py::array_t<double>(static_cast<py::ssize_t>(times.size()), times.data());
             })
        .def("arrays", &FramesOfPython::arrays)
        .def("default_names", &FramesOfPython::default_names)
        .def("analyze", &FramesOfPython::analyze, py::arg("names"), py::arg("settings"));
    module.def("frames_of_file", &frames_of_file, py::arg("path"), py::arg("deck"), py::arg("thermo"), py::arg("start"),
               py::arg("time_step"), py::arg("group"), py::arg("positions"), py::arg("xyz_comment"));
    module.def("frames_of_run", &frames_of_run, py::arg("directory"), py::arg("start"), py::arg("positions"));
}

}  // namespace ljmd::python
