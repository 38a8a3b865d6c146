#include "python/few_body_run.hpp"

#include <fmt/format.h>

#include <optional>

#include "deck/history_columns.hpp"
#include "engine/few_body_system.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/engine/few_body_simulation.hpp"
#include "run/results.hpp"

namespace ljmd::python {

namespace {

/// Rows of trajectory.csv.
class Frames : public RunOutputs {
  public:
    explicit Frames(const Deck& deck)
        : columns_(trajectory_columns(deck, make_few_body_system(deck.few_bodies()))),
          every_(deck.trajectory ? std::optional(deck.trajectory->every) : std::nullopt),
          table_{"trajectory", columns_.names(), {}} {}

    [[nodiscard]] bool frame_is_due(const State& state) const override { return every_ && state.step % *every_ == 0; }
    void frame(const State& state, const std::optional<double>& angle) override {
        if (every_) {
            table_.rows.push_back(columns_.row(state, angle));
        }
    }

    [[nodiscard]] const DataTable& table() const { return table_; }

  private:
    TrajectoryColumns columns_;
    std::optional<Index> every_;
    DataTable table_;
};

class FewBodyRun : public MemoryRun {
  public:
    explicit FewBodyRun(const Deck& deck) : deck_(deck), frames_(deck), simulation_(deck.few_bodies(), {}, &frames_) {}

    void advance(Index steps) override { simulation_.advance(steps); }
    [[nodiscard]] bool finished() const override { return simulation_.finished(); }
    [[nodiscard]] const State& state() const override { return simulation_.state(); }
    [[nodiscard]] const std::vector<Stage>& stages() const override { return simulation_.spec().stages; }

    [[nodiscard]] Data now() const override {
        State copy = state();
        const double potential_energy = chosen_few_body_force(simulation_.spec().force)
                                            .options->make()
                                            ->evaluate(copy, Request::forces_and_energy)
                                            .potential_energy;
        const FewBodyTotals totals = few_body_totals(copy, potential_energy);
        const auto list = [](const Vec3& v) { return Data::list({v[0], v[1], v[2]}); };
        return {{"potential_energy", totals.potential_energy},
                {"kinetic_energy", totals.kinetic_energy},
                {"total_energy", totals.total_energy},
                {"momentum", list(totals.momentum)},
                {"angular_momentum", list(totals.angular_momentum)}};
    }

    [[nodiscard]] Document report() const override { return results_report(deck_, simulation_.result()); }

    [[nodiscard]] std::vector<DataTable> tables() const override {
        std::vector<DataTable> tables = simulation_.result().tables;
        if (!frames_.table().rows.empty()) {
            tables.push_back(frames_.table());
        }
        return tables;
    }

    [[nodiscard]] DataTable thermo() const override {
        const FewBodyThermoColumns columns(static_cast<int>(simulation_.spec().bodies.front().position.size()));
        DataTable table{"thermo", columns.names(), {}};
        for (const FewBodyRow& row : simulation_.samples()) {
            table.rows.push_back(columns.row(row.step, row.time, row.values));
        }
        return table;
    }

    void add(Observer& /*observer*/) override { refuse("observables in Python are"); }
    [[nodiscard]] std::string checkpoint() const override { refuse("a checkpoint in memory is"); }
    void restore(const std::string& /*checkpoint*/) override { refuse("a checkpoint in memory is"); }

  private:
    [[noreturn]] static void refuse(const std::string& what) {
        throw InputError(fmt::format("{} for fluids: this deck has few bodies", what));
    }

    Deck deck_;
    Frames frames_;
    FewBodySimulation simulation_;
};

}  // namespace

std::unique_ptr<MemoryRun> few_body_run(const Deck& deck) {
    return std::make_unique<FewBodyRun>(deck);
}

}  // namespace ljmd::python
