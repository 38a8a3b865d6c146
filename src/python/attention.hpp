#pragma once

#include <chrono>
#include <optional>

#include "ljmd/detail/run/interruption.hpp"
#include "ljmd/detail/run/run_listener.hpp"
#include "python/values.hpp"

namespace ljmd::python {

/// Gives Python its turn while the engine computes without the interpreter's lock: every 50 ms signal handlers may run,
/// as Python does in its main thread, and the progress is told. What they raise stops the run at the end of a step.
class Attention : public RunListener {
  public:
    /// @param progress  called with the number of steps that are done; None: not called
    /// @param warn      called with each warning of the run
    Attention(py::object progress, py::object warn);

    void step_done(Index step) override { step_ = step; }
    void warning(const std::string& text) override;

    /// Called after every step, without the lock. @return whether an exception was raised
    bool look();

    /// Keep an exception, to be raised at the end of the step. With the lock.
    void keep(const py::error_already_set& error) { raised_ = error; }
    [[nodiscard]] bool has_raised() const { return raised_.has_value(); }

    /// Raise it, if there is one. With the lock. @param note  for the user; may be empty
    void raise(const std::string& note = {});

    /// Stops a run with a directory, after its checkpoint. @param walltime  [s]
    [[nodiscard]] Interruption interruption(std::optional<double> walltime);

  private:
    using Clock = std::chrono::steady_clock;

    py::object progress_;
    py::object warn_;
    Index step_ = 0;
    int calls_ = 0;
    int calls_between_looks_ = 1;  ///< at the clock
    Clock::time_point last_look_ = Clock::now();
    Clock::time_point last_turn_ = Clock::now();
    std::optional<py::error_already_set> raised_;
};

/// Call a function of the user's, which does not mind being called twice. If Ctrl-C meets it in its first moments it is
/// called again, and the run stops after the step. With the lock.
/// @param attention  whom to tell of Ctrl-C; null: nobody
template <class Call>
auto called_undisturbed(Attention* attention, const Call& call) {
    constexpr std::chrono::milliseconds first_moments{100};
    const auto began = std::chrono::steady_clock::now();
    try {
        return call();
    } catch (const py::error_already_set& error) {
        const bool soon = std::chrono::steady_clock::now() - began < first_moments;
        if (!soon || attention == nullptr || attention->has_raised() || !error.matches(PyExc_KeyboardInterrupt)) {
            throw;
        }
        attention->keep(error);
    }
    return call();
}

}  // namespace ljmd::python
