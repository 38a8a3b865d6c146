#include "python/directory_run.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>

#include "core/text.hpp"
#include "deck/checked_run.hpp"
#include "deck/deck_system.hpp"
#include "ljmd/core/errors.hpp"
#include "python/attention.hpp"
#include "python/errors.hpp"
#include "python/external_force.hpp"
#include "python/loaded_deck.hpp"
#include "python/observer.hpp"
#include "report/written_report.hpp"
#include "run/directory_report.hpp"
#include "run/given/given_record.hpp"
#include "run/held_run.hpp"
#include "run/recorded_run.hpp"
#include "run/results.hpp"
#include "run/run.hpp"
#include "run/run_directory.hpp"

namespace ljmd::python {

namespace {

void require_fluid_for(const PythonObservers& observers, const Deck& deck) {
    if (!observers.empty()) {
        require_fluid(deck, "observables in Python are for fluids: this deck has few bodies");
    }
}

/// Do the work of a run without the interpreter's lock. Ctrl-C raises KeyboardInterrupt when the checkpoint is written.
template <class Work>
void run_freely(PythonObservers& observers, const std::shared_ptr<PythonExternalForce>& external, Attention& attention,
                const std::filesystem::path& directory, const Work& work) {
    observers.attend(&attention);
    if (external) {
        external->attend(&attention);
    }
    try {
        const WithoutLock free;
        work();
    } catch (const Interrupted&) {
        attention.raise(fmt::format("the run has written a checkpoint; to go on: ljmd.resume({})",
                                    string_literal(directory.string())));
        throw;  // its wall time is over
    }
    attention.raise();
}

/// Run a deck in a directory.
void run(const LoadedDeck& loaded, const std::filesystem::path& directory, int threads, const std::string& simd,
         bool replace, std::optional<double> walltime, const py::iterable& observables,
         const py::object& external_force, const py::object& progress, const py::object& warn) {
    PythonObservers observers(observables);
    const auto external = external_force_of(external_force);
    Attention attention(progress, warn);
    Deck deck = loaded.deck;
    deck.directory = directory;
    require_fluid_for(observers, deck);
    deck.given.observers = records_of(observers.all());
    deck.given.external = name_of(external);
    run_freely(observers, external, attention, directory, [&] {
        Diagnostics diagnostics = loaded.diagnostics;
        CheckedRun checked = checked_run(deck, threads, simd, diagnostics);
        for (const std::string& warning : warnings_of(diagnostics)) {
            attention.warning(warning);
        }
        check_directory(deck, replace);
        AnySystem system = make_system(
            deck, std::move(checked.start), checked.execution,
            [&](const std::string& text) { attention.warning(text); }, external);
        run_in_locked_directory(deck, system, replace, attention,
                                {.interruption = attention.interruption(walltime), .observers = observers.all()});
        write_asked_report(deck, [&](const std::string& text) { attention.warning(text); });
    });
}

/// Resume the run in a directory.
void resume(const std::filesystem::path& directory, Index steps, int threads, std::optional<double> walltime,
            const py::iterable& observables, const py::object& external_force, const py::object& progress,
            const py::object& warn) {
    if (steps < 0) {
        throw InputError(fmt::format("{} more steps: allowed are 0 and more", steps));
    }
    PythonObservers observers(observables);
    const auto external = external_force_of(external_force);
    Attention attention(progress, warn);
    run_freely(observers, external, attention, directory, [&] {
        HeldRun held(directory, steps, threads, [&](const std::string& text) { attention.warning(text); },
                     {.by = "Python", .observers = observers.all(), .external = external});
        for (const std::string& warning : held.warnings()) {
            attention.warning(warning);
        }
        const CheckpointHead& from = held.checkpoint();
        AnySystem system = empty_system(held.deck(), from.atoms, from.edges, held.execution(), external);
        run_plan(held.deck(), system, attention,
                 {.interruption = attention.interruption(walltime),
                  .continuation = held.take(),
                  .observers = observers.all()});
        write_asked_report(held.deck(), [&](const std::string& text) { attention.warning(text); });
        held.warn_if_moved();
    });
}

/// (unwrapped positions, velocities, edges, time) by id of the last configuration of a fluid's run.
py::tuple last(const std::filesystem::path& directory) {
    const Deck deck = recorded_run(directory).deck;
    require_fluid(deck, "a few-body run has no box: its trajectory is a table");
    const State state = last_configuration(directory, deck);
    Eigen::Matrix3Xd positions(3, state.count());
    Eigen::Matrix3Xd velocities(3, state.count());
    const auto v = state.velocities();
    for (Index i = 0; i < state.count(); ++i) {
        const Index id = state.ids()[static_cast<std::size_t>(i)];
        positions.col(id) = state.unwrapped(i);
        velocities.col(id) = v.col(i);
    }
    return py::make_tuple(to_python(positions), to_python(velocities), to_python(Vec3(state.box().edges())),
                          state.time);
}

/// "2h" in seconds. @throws InputError
double seconds_of(const std::string& walltime) {
    const auto seconds = parse_wall_time(walltime);
    if (!seconds) {
        throw InputError(fmt::format(
            "walltime: '{}' is no wall time; allowed: a number > 0 with s, min, h or d, as in 90s or 2h", walltime));
    }
    return *seconds;
}

}  // namespace

void bind_directory_runs(py::module_& module) {
    module.def("run", &run, py::arg("deck"), py::arg("directory"), py::arg("threads"), py::arg("simd"),
               py::arg("replace"), py::arg("walltime"), py::arg("observables"), py::arg("external"),
               py::arg("progress"), py::arg("warn"));
    module.def("resume", &resume, py::arg("directory"), py::arg("steps"), py::arg("threads"), py::arg("walltime"),
               py::arg("observables"), py::arg("external"), py::arg("progress"), py::arg("warn"));
    module.def("last_configuration", &last, py::arg("directory"));
    module.def("seconds_of", &seconds_of, py::arg("walltime"));
    module.def("write_report", &write_report, py::arg("directories"), py::arg("page"), py::arg("force"),
               py::call_guard<WithoutLock>());
    module.def(
        "describe", [](const std::filesystem::path& directory) { return to_python(directory_report(directory)); },
        py::arg("directory"));
}

}  // namespace ljmd::python
