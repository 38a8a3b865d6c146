#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "python/attention.hpp"
#include "python/values.hpp"

namespace ljmd::python {

/// An observable that a Python function measures: its mean and the error of it by blocking.
class PythonObserver : public Observer {
  public:
    /// @param function  called with a snapshot, returns a number
    /// @param every     steps between calls
    /// @param energy    whether the snapshot has energy and pressure
    PythonObserver(std::string name, std::string unit, py::object function, Index every, bool energy);

    /// Whom to tell of Ctrl-C; null: nobody. It outlives the steps that follow.
    void attend(Attention* attention) { attention_ = attention; }

    [[nodiscard]] bool needs(Index step) const override { return step % every_ == 0; }
    [[nodiscard]] bool needs_energy() const override { return energy_; }

    /// Without the interpreter's lock. @throws py::error_already_set  what the function raises; InputError unless it
    /// returns a finite number
    void sample(const Snapshot& snapshot) override;

    void archive(Archive& a) override { a(series_); }

    [[nodiscard]] ObserverRecord record() const override { return {name_, unit_, every_, energy_}; }
    [[nodiscard]] std::optional<ObservableAverage> average() const override;

  private:
    [[nodiscard]] double call(const Snapshot& snapshot) const;

    std::string name_;
    std::string unit_;
    py::object function_;
    Index every_;
    bool energy_;
    Attention* attention_ = nullptr;
    BlockingAccumulator series_{1, Covariance::diagonal};
};

/// Observers of one run.
class PythonObservers {
  public:
    /// @param described  tuples (name, unit, function, every, energy)
    explicit PythonObservers(const py::iterable& described);

    void attend(Attention* attention);
    [[nodiscard]] std::vector<Observer*> all() const;
    [[nodiscard]] bool empty() const { return observers_.empty(); }

  private:
    std::vector<std::unique_ptr<PythonObserver>> observers_;
};

/// The class of what functions of observables are called with.
void bind_snapshot(py::module_& module);

}  // namespace ljmd::python
