#include "analyze/evaluated_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/number_text.hpp"
#include "core/text.hpp"
#include "engine/fluid_system.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "forces/atom_energies.hpp"
#include "io/formats/configuration_reader.hpp"
#include "ljmd/core/errors.hpp"
#include "model/box_for_cutoff.hpp"
#include "observables/pairs_too_near.hpp"

namespace ljmd {

namespace {

/// A file that holds one configuration, as a trajectory of one frame.
class OneConfiguration : public TrajectoryReader {
  public:
    OneConfiguration(std::filesystem::path path, const std::optional<SubstanceUnits>& units)
        : path_(std::move(path)), units_(units) {}

  private:
    bool read(Frame& frame) override {
        if (frames() > 0) {
            return false;
        }
        frame = {};
        frame.configuration = read_configuration(path_, units_);
        return true;
    }
    [[noreturn]] void fail(const std::string& message) const override {
        throw DataError(fmt::format("{}: {}", path_.string(), message));
    }

    std::filesystem::path path_;
    std::optional<SubstanceUnits> units_;
};

constexpr std::size_t shown_forces = 5;

/// Of a vector whose squares may be out of the range of numbers.
double length(const Vec3& v) {
    return std::hypot(v[0], v[1], v[2]);
}

double largest_force(const EvaluatedFrame& frame) {
    double largest = 0.0;
    for (Index i = 0; i < frame.state.count(); ++i) {
        largest = std::max(largest, length(frame.state.forces().col(i)));
    }
    return largest;
}

/// Indices of the atoms with the largest forces, in the order of ids where forces are equal.
std::vector<Index> by_force(const EvaluatedFrame& frame) {
    std::vector<Index> atoms = frame.state.index_of();
    const auto f = frame.state.forces();
    std::ranges::stable_sort(atoms, [&](Index a, Index b) { return length(f.col(a)) > length(f.col(b)); });
    return atoms;
}

/// The ids of the atoms; from 1 where the file has none.
std::vector<Index> ids_of(const EvaluatedFrame& frame) {
    std::vector<Index> ids = frame.source.ids;
    if (ids.empty()) {
        ids.resize(static_cast<std::size_t>(frame.state.count()));
        std::iota(ids.begin(), ids.end(), Index{1});
    }
    return ids;
}

Vec3 net_force(const EvaluatedFrame& frame) {
    Vec3 sum = Vec3::Zero();
    for (const Index i : frame.state.index_of()) {
        sum += frame.state.forces().col(i);
    }
    return sum;
}

Data vector_data(const Vec3& v) {
    return Data::list({v[0], v[1], v[2]});
}

/// What is missing in the numbers, one sentence each.
std::vector<std::string> remarks(const EvaluatedFrame& frame) {
    std::vector<std::string> found;
    if (!frame.has_velocities) {
        found.emplace_back(
            "the file has no velocities: the pressure is its virial part alone, W/(3 V) and the tail; rho k_B T is to "
            "be added");
    } else if (!frame.found.pressure) {
        found.emplace_back("a single atom has neither temperature nor pressure");
    }
    if (!frame.too_near.empty()) {
        found.push_back(frame.too_near);
    }
    return found;
}

std::optional<double> pressure_of(const EvaluatedFrame& frame) {
    return frame.has_velocities ? frame.found.pressure : std::optional(frame.virial_pressure);
}

std::string number(std::optional<double> value) {
    return value ? fmt::format("{:.10g}", *value) : "-";
}

}  // namespace

std::unique_ptr<TrajectoryReader> open_frames(const std::filesystem::path& path,
                                              const std::optional<SubstanceUnits>& units, const std::string& group,
                                              const std::string& xyz_comment) {
    if (!holds_one_configuration(path)) {
        return open_trajectory(path, units, group, xyz_comment);
    }
    if (!group.empty() || !xyz_comment.empty()) {
        throw InputError(
            fmt::format("{} is a NIST sample configuration or LAMMPS data: these have neither groups of "
                        "particles nor a comment line of extended XYZ",
                        path.string()));
    }
    return std::make_unique<OneConfiguration>(path, units);
}

EvaluatedFrame evaluate_frame(Frame frame, Index number, const FluidSpec& spec, const Execution& execution,
                              const std::string& source) {
    const Configuration& configuration = frame.configuration;
    const double cutoff = spec.potential.cutoff().radius;
    const Box box = box_for_cutoff(Box(configuration.edges), cutoff);
    for (const Mistake& mistake : cutoff_mistakes(cutoff, box)) {
        throw InputError(fmt::format("{}: frame {}: {}", source, number, in_words(mistake)));
    }
    EvaluatedFrame result{
        .number = number,
        .source = {configuration.step, configuration.time, configuration.is_unwrapped, std::move(frame.ids)},
        .state = State(std::ssize(configuration.positions), box, execution),
        .has_velocities = !configuration.velocities.empty(),
        .found = {},
        .virial = Mat3::Zero(),
        .energies = {}};
    State& state = result.state;
    place_configuration(state, configuration);
    const TailCorrection tail = spec.interaction().tail;
    FluidSpec pairs_alone = spec;
    pairs_alone.external = nullptr;
    const Evaluation evaluation = make_force_field(pairs_alone, execution).evaluate(state, Request::forces_and_energy);
    if (!std::isfinite(evaluation.potential_energy) || !evaluation.virial.allFinite() || !state.forces().allFinite()) {
        throw DataError(
            fmt::format("{}: frame {}: atoms overlap, the forces between them are not finite", source, number));
    }
    result.found = thermodynamics(state, evaluation, tail);
    result.virial = evaluation.virial;
    result.tail_energy = tail.energy(result.found.density);
    result.tail_pressure = tail.pressure(result.found.density);
    result.virial_pressure = virial_pressure(state, evaluation, tail);
    result.too_near = too_near_in_words(pairs_too_near(state, spec.potential), spec.potential);
    result.energies = atom_energies(state, spec.potential);
    return result;
}

std::string interaction_in_words(const FluidSpec& spec) {
    const PairPotential& potential = spec.potential;
    std::string words = potential.formula();
    for (const auto& [name, value] : potential.parameters()) {
        words += fmt::format(" {} = {:g},", name, value);
    }
    words += fmt::format("{} truncation '{}', cutoff {:g} sigma", potential.parameters().empty() ? "," : "",
                         potential.truncation(), potential.cutoff().radius);
    if (PairPotential::takes_switch_start(potential.truncation())) {
        words += fmt::format(", switched from {:g}", potential.cutoff().switch_start);
    }
    return words + (spec.has_tail() ? ", with tail corrections" : ", no tail corrections");
}

Document frame_document(const EvaluatedFrame& frame, const FluidSpec& spec, const std::string& source) {
    const State& state = frame.state;
    const Vec3 edges = state.box().edges();
    const Thermodynamics& found = frame.found;
    const bool moves = frame.has_velocities;
    const std::vector<Index> sorted = by_force(frame);
    const auto forces = state.forces();
    const std::vector<Index> ids = ids_of(frame);
    const auto id_of = [&](Index i) { return ids[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])]; };

    Data parameters = Data::object();
    for (const auto& [name, value] : spec.potential.parameters()) {
        parameters[name] = value;
    }
    const bool switched = PairPotential::takes_switch_start(spec.potential.truncation());
    Data all_forces = Data::list();
    for (const Index i : state.index_of()) {
        all_forces.push_back(vector_data(forces.col(i)));
    }
    Data tensor = Data::list();
    for (int a = 0; a < 3; ++a) {
        tensor.push_back(vector_data(frame.virial.row(a)));
    }
    Document document;
    document.data = {{"configuration", source},
                     {"frame", frame.number},
                     {"step", frame.source.step},
                     {"time", frame.source.time},
                     {"atoms", state.count()},
                     {"box_edges", vector_data(edges)},
                     {"density", found.density},
                     {"potential",
                      {{"type", spec.potential.formula()},
                       {"parameters", parameters},
                       {"truncation", spec.potential.truncation()},
                       {"cutoff", spec.potential.cutoff().radius},
                       {"switch_start", switched ? std::optional(spec.potential.cutoff().switch_start) : std::nullopt},
                       {"tail", spec.has_tail()}}},
                     {"potential_energy", found.potential_energy},
                     {"tail_energy", frame.tail_energy},
                     {"kinetic_energy", moves ? std::optional(found.kinetic_energy) : std::nullopt},
                     {"temperature", moves ? found.temperature : std::nullopt},
                     {"pressure", pressure_of(frame)},
                     {"pressure_parts", moves ? "kinetic and virial" : "virial"},
                     {"virial_pressure", frame.virial_pressure},
                     {"tail_pressure", frame.tail_pressure},
                     {"virial", found.virial},
                     {"virial_tensor", tensor},
                     {"net_force", vector_data(net_force(frame))},
                     {"largest_force", largest_force(frame)},
                     {"ids", ids},
                     {"forces", all_forces},
                     {"energies", frame.energies},
                     {"remarks", remarks(frame)}};

    std::string& text = document.text;
    text = fmt::format("{}: {} atoms", source, state.count());
    if (frame.source.step) {
        text += fmt::format(", step {}", *frame.source.step);
    }
    text += fmt::format("\nbox {:.8g} x {:.8g} x {:.8g} sigma^3, density {:.6g}\n{}\n\n", edges[0], edges[1], edges[2],
                        found.density, wrapped(interaction_in_words(spec), screen_columns, 2));
    const auto line = [&](const char* name, const std::string& value, const std::string& meaning) {
        text += fmt::format("{:<18}{:>18}  {}\n", name, value, meaning);
    };
    line("potential energy", number(found.potential_energy),
         spec.has_tail() ? fmt::format("epsilon per atom, {:.6g} of it tail", frame.tail_energy) : "epsilon per atom");
    if (moves) {
        line("kinetic energy", number(found.kinetic_energy), "epsilon per atom");
        line("temperature", number(found.temperature), "epsilon/k_B");
    }
    line("pressure", number(pressure_of(frame)),
         spec.has_tail() ? fmt::format("epsilon/sigma^3, {:.6g} of it tail", frame.tail_pressure) : "epsilon/sigma^3");
    line("virial", number(found.virial), "epsilon: sum of r.f over pairs, no tail");
    for (const auto& [name, a, b] : {std::tuple{"  xx, yy, zz", std::array{0, 1, 2}, std::array{0, 1, 2}},
                                     std::tuple{"  xy, xz, yz", std::array{0, 0, 1}, std::array{1, 2, 2}}}) {
        text += fmt::format("{:<18}", name);
        for (std::size_t k = 0; k < 3; ++k) {
            text += fmt::format("{:>18.8g}", frame.virial(a[k], b[k]));
        }
        text += "\n";
    }
    line("net force", fmt::format("{:.3g}", length(net_force(frame))), "epsilon/sigma: 0 but for rounding");
    text += fmt::format("\nlargest forces [epsilon/sigma] and energies of their atoms [epsilon]\n{:>10}{:>14}", "atom",
                        "force");
    text += fmt::format("{:>14}{:>14}{:>14}{:>14}\n", "x", "y", "z", "energy");
    for (std::size_t k = 0; k < std::min(shown_forces, sorted.size()); ++k) {
        const Index i = sorted[k];
        const Vec3 f = forces.col(i).unaryExpr([](double x) { return without_negative_zero(x); });
        text += fmt::format("{:>10}{:>14.6g}{:>14.6g}{:>14.6g}{:>14.6g}{:>14.6g}\n", id_of(i), length(f), f[0], f[1],
                            f[2], frame.energies[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])]);
    }
    for (const std::string& remark : remarks(frame)) {
        text += fmt::format("\n{}\n", wrapped(remark, screen_columns, 0));
    }
    return document;
}

std::string frame_headings() {
    return fmt::format("{:>8}{:>12}{:>13}{:>14}{:>14}{:>13}\n", "frame", "step", "time", "U/N", "pressure",
                       "max force");
}

std::string frame_row(const EvaluatedFrame& frame) {
    return fmt::format("{:>8}{:>12}{:>13}{:>14.8g}{:>14}{:>13.6g}\n", frame.number,
                       frame.source.step ? fmt::format("{}", *frame.source.step) : "-",
                       frame.source.time ? fmt::format("{:.6g}", *frame.source.time) : "-",
                       frame.found.potential_energy,
                       pressure_of(frame) ? fmt::format("{:.8g}", *pressure_of(frame)) : "-", largest_force(frame));
}

}  // namespace ljmd
