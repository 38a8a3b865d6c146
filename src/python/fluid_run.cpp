#include "fluid_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/engine/simulation.hpp"
#include "ljmd/run/results.hpp"

namespace ljmd::python {

namespace {

double number(const std::optional<double>& value) {
    return value.value_or(std::nan(""));
}

/// What a deck says, but for the potential of the calling program.
FluidSpec spec_of(const Deck& deck, Start start, const std::optional<PairPotential>& potential) {
    FluidSpec spec = fluid_spec(deck, std::move(start));
    if (potential) {
        if (spec.tail) {
            throw InputError("a pair potential in Python is not known beyond its cutoff: it takes tail=False");
        }
        spec.potential = *potential;
    }
    return spec;
}

class FluidRun : public MemoryRun {
  public:
    FluidRun(const Deck& deck, FluidSpec spec, const Execution& execution)
        : deck_(deck), simulation_(std::move(spec), execution) {}

    [[nodiscard]] const std::vector<std::string>& warnings() const { return simulation_.warnings(); }

    void advance(Index steps) override {
        if (steps < steps_left()) {
            simulation_.advance(steps);
        } else if (!finished()) {
            simulation_.run();  // also through stages without steps
        }
    }
    [[nodiscard]] bool finished() const override { return simulation_.finished(); }
    [[nodiscard]] const State& state() const override { return simulation_.state(); }
    [[nodiscard]] const std::vector<Stage>& stages() const override { return simulation_.spec().stages; }

    [[nodiscard]] Data now() const override {
        const Thermodynamics values = simulation_.thermodynamics();
        return {{"temperature", values.temperature},
                {"potential_energy", values.potential_energy},
                {"kinetic_energy", values.kinetic_energy},
                {"total_energy", values.total_energy},
                {"pressure", values.pressure},
                {"density", values.density}};
    }

    [[nodiscard]] Document report() const override { return results_report(deck_, simulation_.result()); }

    [[nodiscard]] std::vector<DataTable> tables() const override {
        std::vector<DataTable> tables;
        for (const DataTable& table : simulation_.result().tables) {
            tables.push_back(with_si_columns(table, deck_.units));
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

/// The columns of thermo.csv, see ThermoCsv.
DataTable FluidRun::thermo() const {
    const auto any = [&](const auto& wanted) { return std::ranges::any_of(stages(), wanted); };
    const bool density = any([](const Stage& stage) { return stage.barostat.has_value(); });
    const bool conserved = any([](const Stage& stage) { return stage.thermostat && conserves_energy(stage); });
    const std::vector<ThermoRow>& rows = simulation_.samples();
    const bool order = !rows.empty() && rows.front().order.has_value();
    DataTable table{"thermo",
                    {"step", "time", "temperature", "potential_energy", "kinetic_energy", "total_energy", "pressure",
                     "pressure_xx", "pressure_yy", "pressure_zz", "pressure_xy", "pressure_xz", "pressure_yz"},
                    {}};
    const auto add_column = [&table](bool wanted, const char* name) {
        if (wanted) {
            table.columns.emplace_back(name);
        }
    };
    add_column(density, "density");
    add_column(conserved, "conserved_energy");
    add_column(order, "order_parameter");
    for (const char* name : {"time_ps", "temperature_K", "potential_energy_kJ_per_mol", "kinetic_energy_kJ_per_mol",
                             "total_energy_kJ_per_mol", "pressure_bar"}) {
        add_column(deck_.units.has_value(), name);
    }
    constexpr std::array<std::array<int, 2>, 6> elements{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
    for (const ThermoRow& row : rows) {
        const Thermodynamics& values = row.values;
        std::vector<double> line{static_cast<double>(row.step), row.time,
                                 number(values.temperature),    values.potential_energy,
                                 values.kinetic_energy,         values.total_energy,
                                 number(values.pressure)};
        for (const auto& [a, b] : elements) {
            line.push_back(values.pressure_tensor ? (*values.pressure_tensor)(a, b) : std::nan(""));
        }
        for (const auto& [wanted, value] : {std::pair{density, values.density},
                                            {conserved, number(row.conserved_energy)},
                                            {order, number(row.order)}}) {
            if (wanted) {
                line.push_back(value);
            }
        }
        if (deck_.units) {
            const double kilojoule = deck_.units->kilojoule_per_mole();
            line.insert(line.end(),
                        {row.time * deck_.units->picosecond(), number(values.temperature) * deck_.units->kelvin(),
                         values.potential_energy * kilojoule, values.kinetic_energy * kilojoule,
                         values.total_energy * kilojoule, number(values.pressure) * deck_.units->bar()});
        }
        table.rows.push_back(std::move(line));
    }
    return table;
}

}  // namespace

std::unique_ptr<MemoryRun> fluid_run(const Deck& deck, Start start, const Execution& execution,
                                     const std::optional<PairPotential>& potential,
                                     const std::function<void(const std::string&)>& warn) {
    auto run = std::make_unique<FluidRun>(deck, spec_of(deck, std::move(start), potential), execution);
    for (const std::string& warning : run->warnings()) {
        warn(warning);
    }
    return run;
}

}  // namespace ljmd::python
