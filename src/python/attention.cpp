#include "python/attention.hpp"

#include <algorithm>
#include <csignal>
#include <utility>

namespace ljmd::python {

namespace {

constexpr std::chrono::milliseconds between_turns{50};
constexpr std::chrono::milliseconds soon{1};
constexpr std::chrono::milliseconds late{10};
constexpr int most_calls_between_looks = 1024;

}  // namespace

Attention::Attention(py::object progress, py::object warn) : progress_(std::move(progress)), warn_(std::move(warn)) {}

void Attention::warning(const std::string& text) {
    const WithLock lock;
    called(warn_, python_text(text));
}

bool Attention::look() {
    if (raised_) {
        return true;
    }
    if (++calls_ < calls_between_looks_) {
        return false;
    }
    // A step of a few bodies takes about as long as a look at the clock.
    calls_ = 0;
    const Clock::time_point now = Clock::now();
    if (now - last_look_ < soon) {
        calls_between_looks_ = std::min(2 * calls_between_looks_, most_calls_between_looks);
    } else if (now - last_look_ > late) {
        calls_between_looks_ = std::max(calls_between_looks_ / 2, 1);
    }
    last_look_ = now;
    if (now - last_turn_ < between_turns) {
        return false;
    }
    const WithLock lock;
    try {
        if (unless_python_ends([] { return PyErr_CheckSignals(); }) != 0) {
            throw py::error_already_set();
        }
        if (!progress_.is_none()) {
            called(progress_, step_);
        }
    } catch (const py::error_already_set& error) {
        keep(error);
    }
    last_turn_ = Clock::now();
    return raised_.has_value();
}

void Attention::raise(const std::string& note) {
    if (!raised_) {
        return;
    }
    const py::error_already_set error = *std::exchange(raised_, std::nullopt);
    if (!note.empty() && py::hasattr(error.value(), "add_note")) {  // Python 3.11
        error.value().attr("add_note")(python_text(note));
    }
    throw py::error_already_set(error);
}

Interruption Attention::interruption(std::optional<double> walltime) {
    return Interruption(walltime, [this]() -> std::optional<StopRequest> {
        return look() ? std::optional(StopRequest{SIGINT, "SIGINT"}) : std::nullopt;
    });
}

}  // namespace ljmd::python
