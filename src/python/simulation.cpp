#include "python/simulation.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "python/attention.hpp"
#include "python/errors.hpp"
#include "python/external_force.hpp"
#include "python/loaded_deck.hpp"
#include "python/memory_run.hpp"
#include "python/observer.hpp"

namespace ljmd::python {

namespace {

using Clock = std::chrono::steady_clock;

/// [s]; the steps between two turns of Python take about that long.
constexpr double part_of_turn = 0.02;

/// A run in memory as Python holds it. While it takes steps the interpreter's lock is free, and other threads of
/// Python, or the functions of its own observables, must not look at it.
class PythonSimulation {
  public:
    PythonSimulation(const LoadedDeck& deck, int threads, const std::string& simd, const py::iterable& observables,
                     const py::object& external, const py::object& warn)
        : observers_(observables), external_(external_force_of(external)) {
        const auto tell = [&warn](const std::string& text) {
            const WithLock lock;
            called(warn, python_text(text));
        };
        {
            const WithoutLock free;
            Diagnostics diagnostics = deck.diagnostics;
            CheckedRun checked = checked_run(deck.deck, threads, simd, diagnostics);
            for (const std::string& warning : warnings_of(diagnostics)) {
                tell(warning);
            }
            run_ = memory_run(deck.deck, std::move(checked), external_, tell);
        }
        for (Observer* observer : observers_.all()) {
            run_->add(*observer);
        }
        const WithoutLock free;
        run_->advance(0);
    }

    /// The run, if nobody else works on it now.
    [[nodiscard]] const MemoryRun& run() const {
        if (is_running_) {
            raise("InUseError",
                  "this simulation takes steps at this moment: in another thread, or in the step that has called this "
                  "function, which looks at its snapshot instead");
        }
        return *run_;
    }

    void advance(Index steps, const py::object& progress) {
        if (steps < 0) {
            throw InputError("a number of steps is 0 or more");
        }
        require_no_view();
        Attention attention(progress, py::none());
        const Running running(*this, attention);
        {
            const WithoutLock free;
            take(steps, attention);
        }
        attention.raise();
    }

    void restore(const std::string& checkpoint) {
        require_no_view();
        run_->restore(checkpoint);
    }

    /// Someone looks at the memory of the atoms, which must not move meanwhile.
    class View {
      public:
        explicit View(PythonSimulation& simulation) : simulation_(simulation) { ++simulation_.views_; }
        ~View() { --simulation_.views_; }
        View(const View&) = delete;
        View& operator=(const View&) = delete;

        [[nodiscard]] const State& state() const { return simulation_.run().state(); }

      private:
        PythonSimulation& simulation_;
    };

  private:
    /// Whom functions in Python tell of Ctrl-C.
    void attend(Attention* attention) {
        observers_.attend(attention);
        if (external_) {
            external_->attend(attention);
        }
    }

    /// Before the atoms move in memory.
    void require_no_view() const {
        static_cast<void>(run());
        if (views_ > 0) {
            PyErr_SetString(
                PyExc_BufferError,
                "arrays of this simulation, from `with sim.arrays()`, are still in use: leave the block and "
                "delete its arrays before the next step, or keep copies");
            throw py::error_already_set();
        }
    }

    /// From its making to its end the simulation takes steps.
    class Running {
      public:
        Running(PythonSimulation& simulation, Attention& attention) : simulation_(simulation) {
            simulation_.is_running_ = true;
            simulation_.attend(&attention);
        }
        ~Running() {
            simulation_.attend(nullptr);
            simulation_.is_running_ = false;
        }
        Running(const Running&) = delete;
        Running& operator=(const Running&) = delete;

      private:
        PythonSimulation& simulation_;
    };

    /// Take steps until they are done or an exception was raised in between.
    void take(Index steps, Attention& attention) {
        Index left = std::min(steps, std::max(run_->steps_left(), Index{1}));
        do {
            const Index part = std::min(left, part_);
            const Clock::time_point began = Clock::now();
            run_->advance(part);
            const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
            const double fitting = static_cast<double>(part) * part_of_turn / std::max(seconds, 1e-9);
            part_ = std::clamp(static_cast<Index>(std::min(fitting, 1e12)), Index{1}, 8 * part + 8);
            left -= part;
            attention.step_done(run_->state().step);
        } while (!attention.look() && left > 0 && !run_->finished());
    }

    PythonObservers observers_;
    std::shared_ptr<PythonExternalForce> external_;  ///< null: none
    std::unique_ptr<MemoryRun> run_;
    Index part_ = 1;  ///< steps that take about part_of_turn
    int views_ = 0;   ///< of the memory of its atoms
    std::atomic<bool> is_running_ = false;
};

/// Read-only array on memory of the simulation. @param owner  the View that lives as long as the array
template <class T>
py::array view_of(const T* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                  const py::object& owner) {
    py::array array(py::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

template <class Columns>
py::array vectors_view(const Columns& columns, const py::object& owner) {
    constexpr auto number = static_cast<py::ssize_t>(sizeof(double));
    return view_of(columns.data(), {columns.cols(), 3}, {vector_stride * number, number}, owner);
}

template <class T>
py::array numbers_view(const std::vector<T>& numbers, const py::object& owner) {
    return view_of(numbers.data(), {static_cast<py::ssize_t>(numbers.size())}, {static_cast<py::ssize_t>(sizeof(T))},
                   owner);
}

/// Vectors of all atoms by id, shape (N, 3).
template <class Column>
py::array_t<double> by_id(const State& state, const Column& column) {
    py::array_t<double> array({state.count(), Index{3}});
    double* to = array.mutable_data();
    const std::vector<Index>& ids = state.ids();
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3 vector = column(i);
        std::copy(vector.data(), vector.data() + 3, to + 3 * ids[static_cast<std::size_t>(i)]);
    }
    return array;
}

py::array_t<double> positions(const State& state) {
    const auto r = state.positions();
    if (!state.has_box()) {
        return by_id(state, [&r](Index i) { return r.col(i); });
    }
    const Box& box = state.box();
    return by_id(state, [&](Index i) -> Vec3 {
        const Vec3 x = r.col(i);
        if ((x.array() >= 0.0).all() && (x.array() < box.edges().array()).all()) {
            return x;  // as most are: three divisions less
        }
        return x - box.crossings(x).cwiseProduct(box.edges());
    });
}

py::array_t<double> masses(const State& state) {
    py::array_t<double> array(state.count());
    const std::vector<Index>& ids = state.ids();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        array.mutable_at(ids[i]) = state.masses()[i];
    }
    return array;
}

py::object edges(const State& state) {
    return state.has_box() ? py::object(to_python(Vec3(state.box().edges()))) : py::none();
}

/// Number of the present stage; at the end, of the last one.
std::string stage_name(const MemoryRun& run) {
    Index end = 0;
    for (const Stage& stage : run.stages()) {
        end += stage.steps;
        if (run.state().step < end) {
            return stage.name;
        }
    }
    return run.stages().back().name;
}

}  // namespace

void bind_simulation(py::module_& module) {
    using Sim = const PythonSimulation&;
    using View = PythonSimulation::View;
    py::class_<View>(module, "View", "Memory of the atoms of a simulation, in its present order.")
        .def("positions", [](const py::object& v) { return vectors_view(v.cast<View&>().state().positions(), v); })
        .def("velocities", [](const py::object& v) { return vectors_view(v.cast<View&>().state().velocities(), v); })
        .def("forces", [](const py::object& v) { return vectors_view(v.cast<View&>().state().forces(), v); })
        .def("masses", [](const py::object& v) { return numbers_view(v.cast<View&>().state().masses(), v); })
        .def("ids", [](const py::object& v) { return numbers_view(v.cast<View&>().state().ids(), v); });
    py::class_<PythonSimulation>(module, "Simulation", "A run in memory.")
        .def(py::init<const LoadedDeck&, int, const std::string&, const py::iterable&, const py::object&,
                      const py::object&>(),
             py::arg("deck"), py::arg("threads"), py::arg("simd"), py::arg("observables"), py::arg("external"),
             py::arg("warn"))
        .def("advance", &PythonSimulation::advance, py::arg("steps"), py::arg("progress"))
        .def(
            "view",
            [](PythonSimulation& s) {
                static_cast<void>(s.run());
                return std::make_unique<View>(s);
            },
            py::keep_alive<0, 1>())
        .def("finished", [](Sim s) { return s.run().finished(); })
        .def("step", [](Sim s) { return s.run().state().step; })
        .def("total_steps", [](Sim s) { return total_steps(s.run().stages()); })
        .def("time", [](Sim s) { return s.run().state().time; })
        .def("stage", [](Sim s) { return stage_name(s.run()); })
        .def("atoms", [](Sim s) { return s.run().state().count(); })
        .def("edges", [](Sim s) { return edges(s.run().state()); })
        .def("positions", [](Sim s) { return positions(s.run().state()); })
        .def("unwrapped",
             [](Sim s) {
                 const State& state = s.run().state();
                 return by_id(state, [&](Index i) { return state.unwrapped(i); });
             })
        .def("velocities",
             [](Sim s) {
                 const auto v = s.run().state().velocities();
                 return by_id(s.run().state(), [&v](Index i) { return v.col(i); });
             })
        .def("forces",
             [](Sim s) {
                 const auto f = s.run().state().forces();
                 return by_id(s.run().state(), [&f](Index i) { return f.col(i); });
             })
        .def("masses", [](Sim s) { return masses(s.run().state()); })
        .def("now", [](Sim s) { return to_python(s.run().now()); })
        .def("report", [](Sim s) { return to_python(s.run().report()); })
        .def("tables", [](Sim s) { return to_python(s.run().tables()); })
        .def("thermo", [](Sim s) { return to_python(s.run().thermo()); })
        .def("checkpoint", [](Sim s) { return py::bytes(s.run().checkpoint()); })
        .def("restore", &PythonSimulation::restore, py::arg("checkpoint"));
}

}  // namespace ljmd::python
