#include "python/fluid_run.hpp"

#include <memory>
#include <utility>

#include "deck/history_columns.hpp"
#include "ljmd/engine/simulation.hpp"
#include "run/results.hpp"

namespace ljmd::python {

namespace {

class FluidRun : public MemoryRun {
  public:
    FluidRun(const Deck& deck, FluidSpec spec, const Execution& execution)
        : deck_(deck), simulation_(std::move(spec), execution) {}

    [[nodiscard]] const std::vector<std::string>& warnings() const { return simulation_.warnings(); }

    void advance(Index steps) override { simulation_.advance(steps); }
    [[nodiscard]] bool finished() const override { return simulation_.finished(); }
    [[nodiscard]] const State& state() const override { return simulation_.state(); }
    [[nodiscard]] const std::vector<Stage>& stages() const override { return simulation_.spec().stages; }

    [[nodiscard]] Data now() const override {
        const Thermodynamics values = simulation_.thermodynamics();
        return {{"temperature", values.temperature},
                {"potential_energy", values.potential_energy},
                {"kinetic_energy", values.kinetic_energy},
                {"total_energy", values.total_energy},
                {"external_energy", values.external_energy},
                {"pressure", values.pressure},
                {"density", values.density}};
    }

    [[nodiscard]] Document report() const override { return results_report(deck_, simulation_.result()); }

    [[nodiscard]] std::vector<DataTable> tables() const override {
        std::vector<DataTable> tables;
        for (const DataTable& table : simulation_.result().tables) {
            tables.push_back(with_si_columns(table, deck_.units()));
        }
        return tables;
    }

    [[nodiscard]] DataTable thermo() const override;

    void add(Observer& observer) override { simulation_.add(observer); }
    [[nodiscard]] std::string checkpoint() const override { return simulation_.checkpoint(); }
    void restore(const std::string& checkpoint) override { simulation_.restore(checkpoint); }

  private:
    Deck deck_;
    Simulation simulation_;
};

DataTable FluidRun::thermo() const {
    const std::vector<ThermoRow>& rows = simulation_.samples();
    const ThermoColumns columns =
        thermo_columns(deck_, !rows.empty() && rows.front().order, simulation_.spec().external.get());
    DataTable table{"thermo", columns.names(), {}};
    for (const ThermoRow& row : rows) {
        table.rows.push_back(columns.row(row.step, row.time, row.values, {row.conserved_energy, row.order}));
    }
    return table;
}

}  // namespace

std::unique_ptr<MemoryRun> fluid_run(const Deck& deck, Start start, const Execution& execution,
                                     const std::shared_ptr<ExternalForce>& external,
                                     const std::function<void(const std::string&)>& warn) {
    FluidSpec spec = fluid_spec(deck, std::move(start));
    spec.external = external;
    auto run = std::make_unique<FluidRun>(deck, std::move(spec), execution);
    for (const std::string& warning : run->warnings()) {
        warn(warning);
    }
    return run;
}

}  // namespace ljmd::python
