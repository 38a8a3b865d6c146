#include "python/few_body_run.hpp"

#include <fmt/format.h>

#include <utility>

#include "deck/history_columns.hpp"
#include "engine/few_body_measurement.hpp"
#include "engine/few_body_system.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "run/results.hpp"

namespace ljmd::python {

namespace {

/// Rows of thermo.csv and trajectory.csv.
class Rows : public RunOutputs {
  public:
    Rows(const Deck& deck, const FewBodySystem& system)
        : thermo_columns_(system.dimensions), trajectory_columns_(trajectory_columns(deck, system)) {
        if (deck.trajectory) {
            frames_every_ = deck.trajectory->every;
        }
        thermo = {"thermo", thermo_columns_.names(), {}};
        trajectory = {"trajectory", trajectory_columns_.names(), {}};
    }

    using RunOutputs::row;
    void row(const FewBodyRow& row) override {
        thermo.rows.push_back(thermo_columns_.row(row.step, row.time, row.values));
    }

    [[nodiscard]] bool frame_is_due(const State& state) const override {
        return frames_every_ && state.step % *frames_every_ == 0;
    }

    void frame(const State& state, const std::optional<double>& angle) override {
        if (frames_every_) {
            trajectory.rows.push_back(trajectory_columns_.row(state, angle));
        }
    }

    DataTable thermo;
    DataTable trajectory;

  private:
    FewBodyThermoColumns thermo_columns_;
    TrajectoryColumns trajectory_columns_;
    std::optional<Index> frames_every_;
};

class FewBodyRun : public MemoryRun {
  public:
    explicit FewBodyRun(const Deck& deck)
        : deck_(deck),
          system_(make_few_body_system(deck.few_bodies())),
          rows_(deck, system_),
          measurement_(deck_.stages(), deck_.sample_every(), system_, rows_) {}

    void advance(Index steps) override {
        if (failed_) {
            throw InputError("this simulation has failed: it can be looked at, but not be continued");
        }
        if (finished()) {
            return;
        }
        failed_ = true;  // unless this comes to its end
        const auto until = steps < steps_left() ? std::optional(system_.state.step + steps) : std::nullopt;
        try {
            position_ = run_stages(deck_.stages(), system_.state, *system_.force_field, measurement_, position_,
                                   std::nullopt, until);
            if (finished()) {
                measurement_.record_end();
            }
        } catch (...) {
            system_.state.finish_kick();  // so that the state can be looked at
            throw;
        }
        failed_ = false;
    }

    [[nodiscard]] bool finished() const override { return position_ && position_->stage == deck_.stages().size(); }
    [[nodiscard]] const State& state() const override { return system_.state; }
    [[nodiscard]] const std::vector<Stage>& stages() const override { return deck_.stages(); }

    [[nodiscard]] Data now() const override {
        State copy = state();
        const double potential_energy =
            system_.force.options->make()->evaluate(copy, Request::forces_and_energy).potential_energy;
        const FewBodyTotals totals = few_body_totals(copy, potential_energy);
        const auto list = [](const Vec3& v) { return Data::list({v[0], v[1], v[2]}); };
        return {{"potential_energy", totals.potential_energy},
                {"kinetic_energy", totals.kinetic_energy},
                {"total_energy", totals.total_energy},
                {"momentum", list(totals.momentum)},
                {"angular_momentum", list(totals.angular_momentum)}};
    }

    [[nodiscard]] Document report() const override { return results_report(deck_, result()); }

    [[nodiscard]] std::vector<DataTable> tables() const override {
        std::vector<DataTable> tables = result().tables;
        if (!rows_.trajectory.rows.empty()) {
            tables.push_back(rows_.trajectory);
        }
        return tables;
    }

    [[nodiscard]] DataTable thermo() const override { return rows_.thermo; }

    void add(Observer& /*observer*/) override { refuse("observables in Python are"); }
    [[nodiscard]] std::string checkpoint() const override { refuse("a checkpoint in memory is"); }
    void restore(const std::string& /*checkpoint*/) override { refuse("a checkpoint in memory is"); }

  private:
    [[noreturn]] static void refuse(const std::string& what) {
        throw InputError(fmt::format("{} for fluids: this deck has few bodies", what));
    }

    [[nodiscard]] FewBodyResult result() const {
        return measurement_.result(position_ ? position_->seconds : LoopSeconds{});
    }

    Deck deck_;
    FewBodySystem system_;
    Rows rows_;
    FewBodyMeasurement measurement_;
    std::optional<LoopPosition> position_;  ///< empty until the first step
    bool failed_ = false;
};

}  // namespace

std::unique_ptr<MemoryRun> few_body_run(const Deck& deck) {
    return std::make_unique<FewBodyRun>(deck);
}

}  // namespace ljmd::python
