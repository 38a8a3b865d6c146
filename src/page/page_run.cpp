#include "page/page_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <utility>

#include "deck/checked_run.hpp"
#include "deck/fluid.hpp"
#include "io/files/input_file.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/elementary.hpp"
#include "model/checksum.hpp"
#include "model/velocities.hpp"
#include "run/results.hpp"

namespace ljmd {

namespace {

/// Moves one atom by the spacing of the grid on which the bit-reversible integrator computes, once.
class FlippedBit : public ExternalForce {
  public:
    FlippedBit(double time, double time_step) : time_(time), time_step_(time_step) {}

    [[nodiscard]] std::string name() const override { return "one flipped bit"; }
    [[nodiscard]] bool has_energy() const override { return false; }
    ExternalEnergy compute(const AtomPositions& atoms, bool /*energy*/, Eigen::Matrix3Xd& forces) override {
        if (std::abs(atoms.time() - time_) < 0.5 * time_step_) {
            forces(0, 0) = Box(atoms.edges()).resolution() / (time_step_ * time_step_);
        }
        return {};
    }

  private:
    double time_;
    double time_step_;
};

Data vector_data(const Vec3& v) {
    return Data::list({v[0], v[1], v[2]});
}

Data row_data(const ThermoRow& row) {
    const Thermodynamics& v = row.values;
    return Data::list({row.step, row.time, v.temperature, v.potential_energy, v.kinetic_energy, v.total_energy,
                       v.pressure, row.conserved_energy, row.order});
}

Data row_data(const FewBodyRow& row) {
    const FewBodyTotals& v = row.values;
    return Data::list(
        {row.step, row.time, v.potential_energy, v.kinetic_energy, v.total_energy, v.angular_momentum[2]});
}

Data bodies_data(const State& bodies) {
    Data all = Data::list();
    for (Index i = 0; i < bodies.count(); ++i) {
        all.push_back(vector_data(bodies.positions().col(i)));
    }
    return all;
}

const std::vector<const char*>& columns(bool is_fluid) {
    static const std::vector<const char*> fluid{"step",           "time",         "temperature", "potential_energy",
                                                "kinetic_energy", "total_energy", "pressure",    "conserved_energy",
                                                "order"};
    static const std::vector<const char*> few_bodies{"step",           "time",         "potential_energy",
                                                     "kinetic_energy", "total_energy", "angular_momentum_z"};
    return is_fluid ? fluid : few_bodies;
}

Data table_data(const DataTable& table) {
    Data values = Data::list();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        Data of_column = Data::list();
        for (const std::vector<double>& row : table.rows) {
            of_column.push_back(row[column]);
        }
        values.push_back(std::move(of_column));
    }
    return {{"name", table.name}, {"columns", table.columns}, {"values", std::move(values)}};
}

Data tables_data(const std::vector<DataTable>& tables) {
    Data all = Data::list();
    for (const DataTable& table : tables) {
        all.push_back(table_data(table));
    }
    return all;
}

/// Along the edges of a box that are much longer than others: by which part of the edge atoms have to be moved so that
/// their middle, the direction of the mean of exp(2 pi i x/L), is the middle of the box. A film is then seen whole.
Vec3 middle_of_long_box(const State& atoms) {
    const Vec3 edges = atoms.box().edges();
    Vec3 shift = Vec3::Zero();
    for (Index axis = 0; axis < 3; ++axis) {
        if (edges[axis] < 1.5 * edges.minCoeff()) {
            continue;
        }
        std::complex<double> sum = 0.0;
        for (Index i = 0; i < atoms.count(); ++i) {
            sum += std::polar(1.0, 2.0 * std::numbers::pi * atoms.positions()(axis, i) / edges[axis]);
        }
        shift[axis] = 0.5 - std::arg(sum) / (2.0 * std::numbers::pi);
    }
    return shift;
}

Data stages_data(const std::vector<Stage>& stages) {
    Data all = Data::list();
    for (const Stage& stage : stages) {
        all.push_back({{"name", stage.name},
                       {"steps", stage.steps},
                       {"time_step", stage.time_step},
                       {"sample", stage.sample},
                       {"reverse", stage.reverse},
                       {"temperature", stage.temperature}});
    }
    return all;
}

}  // namespace

PageRun::PageRun(const std::string& name, const std::string& text, const std::vector<std::string>& settings, bool force,
                 double flip) {
    Diagnostics diagnostics;
    std::optional<Deck> deck = load_deck_text(name, text, settings, force, diagnostics);
    diagnostics.throw_if_errors();
    deck_ = std::move(deck).value();
    CheckedRun checked = checked_run(deck_, 1, "portable", diagnostics);
    for (const Diagnostic& entry : diagnostics.entries()) {
        warnings_.push_back(format(entry));
    }
    if (!deck_.is_fluid()) {
        run_.emplace(std::in_place_type<FewBodySimulation>, deck_.few_bodies());
        return;
    }
    if (*checked.atoms() > most_atoms) {
        throw InputError(
            fmt::format("{} atoms: a page takes up to {}; `ljmd run` takes more", *checked.atoms(), most_atoms));
    }
    FluidSpec spec = fluid_spec(deck_, std::move(*checked.start));
    if (flip >= 0.0) {
        spec.external = std::make_shared<FlippedBit>(flip, spec.stages.back().time_step);
    }
    run_.emplace(std::in_place_type<Simulation>, std::move(spec), checked.execution);
    for (const std::string& warning : std::get<Simulation>(*run_).warnings()) {
        warnings_.push_back("warning: " + warning);
    }
}

const State& PageRun::state() const {
    return std::visit([](const auto& run) -> const State& { return run.state(); }, *run_);
}

const Stage& PageRun::present_stage() const {
    Index before = 0;
    for (const Stage& stage : deck_.stages()) {
        before += stage.steps;
        if (state().step < before) {
            return stage;
        }
    }
    return deck_.stages().back();
}

Data PageRun::description() const {
    Data data = {{"kind", kind_name(deck_)},
                 {"title", deck_.title},
                 {"atoms", state().total()},
                 {"steps", total_steps(deck_.stages())},
                 {"stages", stages_data(deck_.stages())},
                 {"columns", columns(deck_.is_fluid())},
                 {"warnings", warnings_},
                 {"deck", deck_.source}};
    if (state().has_box()) {
        data["edges"] = vector_data(state().box().edges());
        data["density"] =
            state().box().volume() > 0.0 ? static_cast<double>(state().total()) / state().box().volume() : 0.0;
    } else {
        Data masses = Data::list();
        for (const double mass : state().masses()) {
            masses.push_back(mass);
        }
        data["masses"] = std::move(masses);
        data["force"] = deck_.few_bodies().force.name;
    }
    if (const auto& units = deck_.units()) {
        data["si"] = {{"kelvin", units->kelvin()},
                      {"bar", units->bar()},
                      {"picosecond", units->picosecond()},
                      {"nanometre", units->nanometre()},
                      {"kilojoule_per_mole", units->kilojoule_per_mole()}};
    }
    return data;
}

Data PageRun::advance(Index steps) {
    return std::visit(
        [&](auto& run) -> Data {
            run.advance(steps);
            Data rows = Data::list();
            for (; told_ < run.samples().size(); ++told_) {
                rows.push_back(row_data(run.samples()[told_]));
            }
            Data data = {{"step", run.state().step},           {"time", run.state().time},
                         {"finished", run.finished()},         {"stage", present_stage().name},
                         {"sampling", present_stage().sample}, {"rows", std::move(rows)}};
            if (run.state().has_box()) {
                data["edges"] = vector_data(run.state().box().edges());
            } else {
                data["bodies"] = bodies_data(run.state());
            }
            return data;
        },
        *run_);
}

Data PageRun::result() const {
    return std::visit(
        [&](const auto& run) -> Data {
            const auto result = run.result();
            const Document report = results_report(deck_, result);
            return {{"results", report.data}, {"text", report.text}, {"tables", tables_data(result.tables)}};
        },
        *run_);
}

Data PageRun::checksum_data() const {
    return {{"step", state().step}, {"checksum", checksum(state())}};
}

Data PageRun::speeds() const {
    const State& atoms = state();
    const double temperature = ljmd::temperature(atoms).value_or(0.0);
    if (!(temperature > 0.0) || !atoms.has_box()) {
        return {};
    }
    const double thermal = std::sqrt(temperature);
    constexpr Index bins = 32;
    const double width = 4.0 * thermal / bins;
    std::vector<double> counts(bins, 0.0);
    const auto v = atoms.velocities();
    for (Index i = 0; i < atoms.count(); ++i) {
        const double place = v.col(i).norm() / width;
        if (place < bins) {
            counts[static_cast<std::size_t>(place)] += 1.0;
        }
    }
    DataTable table{.name = "speeds", .columns = {"speed", "density", "standard_error", "maxwell"}, .rows = {}};
    const auto n = static_cast<double>(atoms.count());
    for (Index bin = 0; bin < bins; ++bin) {
        const double speed = (static_cast<double>(bin) + 0.5) * width;
        const double count = counts[static_cast<std::size_t>(bin)];
        const double reduced = speed * speed / temperature;
        table.rows.push_back({speed, count / (n * width), std::sqrt(std::max(count, 1.0)) / (n * width),
                              std::sqrt(2.0 / std::numbers::pi) * reduced / thermal * exponential(-0.5 * reduced)});
    }
    return table_data(table);
}

std::string PageRun::configuration() const {
    const std::filesystem::path path = "/kept.xyz";
    write_configuration(OutputPlace(path), state(), true);
    return read_input(path);
}

void PageRun::draw() {
    const State& atoms = state();
    const auto n = static_cast<std::size_t>(atoms.count());
    positions_.resize(3 * n);
    speeds_.resize(n);
    const auto v = atoms.velocities();
    const double fastest = 3.0 * std::sqrt(std::max(ljmd::temperature(atoms).value_or(1.0), 1e-12));
    const Vec3 edges = atoms.box().edges();
    const Vec3 shift = middle_of_long_box(atoms);
    for (Index i = 0; i < atoms.count(); ++i) {
        const auto atom = static_cast<std::size_t>(atoms.ids()[static_cast<std::size_t>(i)]);
        for (Index axis = 0; axis < 3; ++axis) {
            const double at = atoms.positions()(axis, i) / edges[axis] + shift[axis];
            positions_[3 * atom + static_cast<std::size_t>(axis)] =
                static_cast<std::uint16_t>(std::clamp((at - std::floor(at)) * 65536.0, 0.0, 65535.0));
        }
        speeds_[atom] = static_cast<std::uint8_t>(std::clamp(v.col(i).norm() / fastest * 255.0, 0.0, 255.0));
    }
}

}  // namespace ljmd
