#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "judge/explanations.hpp"
#include "judge/joint_diagnosis.hpp"
#include "judge/net_force.hpp"
#include "judge/point_judgement.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"

namespace ljmd {

namespace {

/// A value that a number has by a known mistake.
struct Known {
    double value;
    const char* words;
};

/// The mistake that explains most of a number's difference from the right one.
std::optional<std::string> best_of(double found, double right, double noise, const std::vector<Known>& mistakes) {
    Explanations known(std::abs(found - right), noise, unexplained_of_point);
    for (const Known& mistake : mistakes) {
        known.offer(std::abs(found - mistake.value), mistake.words);
    }
    return known.best();
}

/// What the tail corrections are by a mistake, as sums of rc^-9 and rc^-3 in parts of 8/3 pi rho N (16/3 pi rho^2 of
/// the pressure): a/3 rc^-9 - rc^-3.
std::vector<Known> wrong_tails(const Fluid& fluid, const ExpectedPoint& expected, bool of_pressure) {
    const double right = of_pressure ? expected.tail_pressure : expected.tail_energy;
    if (right == 0.0) {
        return {};
    }
    std::vector<Known> known{{-right, "tail of the wrong sign: the tail correction has it, the pairs are right"},
                             {0.5 * right, "half the tail: the tail correction is half of what it is to be"}};
    if (fluid.potential.formula() == "lennard-jones") {
        const double density = static_cast<double>(expected.atoms) / expected.volume;
        const double x = std::pow(fluid.potential.cutoff().radius, -3);
        const double factor = 8.0 / 3.0 * std::numbers::pi * density *
                              (of_pressure ? 2.0 * density : static_cast<double>(expected.atoms));
        known.push_back({factor * (x * x * x - x),
                         "formula of the tail: rc^-9 has no factor, where it is to have 1/3 "
                         "in the energy and 2/3 in the pressure"});
        known.push_back({factor * ((of_pressure ? 1.0 : 2.0) / 3.0 * x * x * x - x),
                         of_pressure ? "formula of the tail: rc^-9 has 1/3 in the pressure, where it is to have 2/3"
                                     : "formula of the tail: rc^-9 has 2/3 in the energy, where it is to have 1/3"});
    }
    return known;
}

/// Adds to known values those that differ by what a wrong tail makes of them.
std::vector<Known> and_tails(std::vector<Known> known, double without_tail, const std::vector<Known>& tails) {
    for (const Known& tail : tails) {
        known.push_back({without_tail + tail.value, tail.words});
    }
    return known;
}

std::optional<std::string> wrong_energy(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                                        double tolerance) {
    const double found = *answer.potential_energy;
    const double right = expected.potential_energy();
    const double pairs = expected.sums.potential_energy;
    const double tail = expected.tail_energy;
    const double noise = tolerance * std::abs(pairs);
    const auto atoms = static_cast<double>(expected.atoms);
    const double cutoff = fluid.potential.cutoff().radius;
    const double step = static_cast<double>(SummedPairs(fluid.positions, fluid.edges, cutoff).pairs().size()) *
                        fluid.potential.untruncated(cutoff).u;
    const double full_tail =
        atoms * TailCorrection(PairPotential::make(fluid.potential.formula(), "cut", fluid.potential.cutoff(),
                                                   fluid.potential.parameters()))
                    .energy(atoms / expected.volume);
    const double others = (atoms - 1.0) / atoms;
    return best_of(
        found, right, noise,
        and_tails(
            {{right - step, "shifted energy: the potential is shifted to zero at the cutoff, where it is to be cut"},
             {right + step, "shifted energy: the potential is not shifted to zero at the cutoff, as it is to be"},
             {pairs - step,
              "shifted energy and missing tail: the potential is shifted to zero at the cutoff and has no tail "
              "correction"},
             {pairs, "missing tail: the tail correction is left out, the pairs are right"},
             {pairs + 2.0 * tail, "tail twice: the tail correction is added twice, the pairs are right"},
             {pairs + others * tail, "tail of N - 1: the tail correction is that of N - 1 atoms, or N (N - 1) pairs"},
             {pairs + others * others * tail,
              "tail of N - 1: the tail correction is that of N - 1 atoms at their density"},
             {pairs + tail / atoms,
              "tail of one atom: the tail correction is that of one atom, where it is to be that of all"},
             {pairs + full_tail, "tail too many: a tail correction is added, which the problem does not have"},
             {right / atoms, "energy of one atom: the energy is divided by the number of atoms"},
             {0.25 * pairs + tail, "quarter of the energy: the 4 of 4 epsilon is left out for the pairs"},
             {0.25 * (pairs + step) - step + tail,
              "quarter of the energy: the 4 of 4 epsilon is left out, not in the shift"},
             {0.25 * right, "quarter of the energy: the 4 of 4 epsilon is left out"},
             {2.0 * pairs + tail, "pairs twice: every pair is counted twice in the energy"},
             {2.0 * right, "pairs twice: every pair is counted twice in the energy"},
             {0.5 * pairs + tail, "half the pairs: the energy of the pairs is half of what it is to be"},
             {-right, "sign: the energy has the wrong sign"},
             {right + expected.kinetic_energy, "total energy: the kinetic energy is in the potential energy"}},
            pairs, wrong_tails(fluid, expected, false)));
}

/// The sum of r_i . f_i over atoms that are wrapped into the box.
double virial_of_atoms(const Fluid& fluid, const std::vector<Vec3>& forces) {
    double sum = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const Vec3& r = fluid.positions[i];
        const Vec3 edges_away = (r.array() / fluid.edges.array()).floor();
        sum += forces[i].dot(r - edges_away.cwiseProduct(fluid.edges));
    }
    return sum;
}

constexpr const char* virial_of_atoms_words =
    "virial: it is the sum of r_i . f_i over atoms in the box, which leaves out the walls; W is the sum over pairs of "
    "r_ij . f_ij, with the nearest images";

std::optional<std::string> wrong_virial(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                                        double tolerance) {
    const double found = *answer.virial;
    const double right = expected.sums.virial;
    const double noise = tolerance * (2.0 * expected.kinetic_energy + std::abs(right));
    return best_of(found, right, noise,
                   {{-right, "virial: the sign is wrong; W is the sum of r . f, positive where atoms repel each other"},
                    {0.5 * right, "virial: half of it; every pair counts once with r . f"},
                    {-0.5 * right, "virial: minus half of it, the virial of Clausius; W is the sum of r . f"},
                    {virial_of_atoms(fluid, expected.sums.forces), virial_of_atoms_words},
                    {2.0 * right, "virial: twice of it; every pair counts once"},
                    {right / 3.0, "virial: a third of it; W is the sum of r . f, the trace of the tensor"},
                    {right + 2.0 * expected.kinetic_energy, "virial: 2 K is in it; W is of the forces alone"},
                    {right + 3.0 * expected.volume * expected.tail_pressure,
                     "virial: the tail correction is in it; W is of the pairs alone"},
                    {3.0 * expected.volume * expected.pressure(), "virial: it is 3 p V; W is of the forces alone"}});
}

std::optional<std::string> wrong_forces(const ExpectedPoint& expected, const PointAnswer& answer, double tolerance) {
    const AnswerParts parts(expected, answer, tolerance);
    const double c = *parts.factor();
    PairSums scaled{0.0, 0.0, expected.sums.forces};
    for (Vec3& f : scaled.forces) {
        f *= c;
    }
    const AnswerPart off = parts.forces(expected.sums);
    if (parts.forces(scaled).off > std::max(off.noise, unexplained_of_point * off.off)) {
        return net_force(answer.forces, expected.sums.forces, off.noise);
    }
    return std::abs(c + 1.0) < unexplained_of_point
               ? std::string("forces: all have the wrong sign")
               : fmt::format("forces: all are {:.10g} times those of the energy's derivative", c);
}

std::optional<std::string> wrong_temperature(const ExpectedPoint& expected, const PointAnswer& answer,
                                             double tolerance) {
    const double found = *answer.temperature;
    const double right = expected.temperature();
    const double kinetic = answer.kinetic_energy.value_or(expected.kinetic_energy);
    const auto atoms = static_cast<double>(expected.atoms);
    return best_of(found, right, tolerance * right,
                   {{2.0 * kinetic / (3.0 * atoms),
                     "3N against 3N-3: the temperature is 2 K/(3 N); at rest the centre of mass takes three degrees of "
                     "freedom, T = 2 K/(3 N - 3)"},
                    {2.0 * kinetic / (3.0 * atoms - 6.0),
                     "3N-6 against 3N-3: the temperature is 2 K/(3 N - 6); in a periodic box nothing but the centre of "
                     "mass is at rest, T = 2 K/(3 N - 3)"},
                    {kinetic / (3.0 * atoms - 3.0), "temperature: it is K/(3 N - 3), half of it"},
                    {4.0 * kinetic / (3.0 * atoms - 3.0), "temperature: it is 4 K/(3 N - 3), twice of it"}});
}

/// A wrong kinetic energy, with what follows from it.
std::optional<std::string> wrong_kinetic_energy(const ExpectedPoint& expected, const PointAnswer& answer,
                                                double tolerance) {
    const double found = *answer.kinetic_energy;
    const double right = expected.kinetic_energy;
    const auto atoms = static_cast<double>(expected.atoms);
    auto words = best_of(found, right, tolerance * right,
                         {{2.0 * right, "kinetic energy: twice as large; K = sum m v^2/2"},
                          {0.5 * right, "kinetic energy: half as large; K = sum m v^2/2"},
                          {right / atoms, "kinetic energy: it is divided by the number of atoms"},
                          {2.0 * right / (3.0 * atoms - 3.0), "kinetic energy: it is the temperature"}});
    if (!words) {
        return words;
    }
    ExpectedPoint with = expected;
    with.kinetic_energy = found;
    if (answer.virial) with.sums.virial = *answer.virial;
    const auto follows = [&](const std::optional<double>& of, double from_it, double from_right) {
        return of && !(relative_difference(*of, from_right) <= tolerance) &&
               relative_difference(*of, from_it) <= tolerance;
    };
    const bool temperature = follows(answer.temperature, with.temperature(), expected.temperature());
    const bool pressure = follows(answer.pressure, with.pressure(), expected.pressure());
    if (temperature || pressure) {
        *words += fmt::format("; {}{}{} with it", temperature ? "the temperature" : "",
                              temperature && pressure ? " and " : "", pressure ? "the pressure" : "");
        *words += temperature && pressure ? " are wrong, too" : " is wrong, too";
    }
    return words;
}

std::optional<std::string> wrong_pressure(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                                          double tolerance) {
    const double found = *answer.pressure;
    const double right = expected.pressure();
    const double volume = expected.volume;
    const double kinetic = 2.0 * expected.kinetic_energy / (3.0 * volume);
    const double ideal = static_cast<double>(expected.atoms) * expected.temperature() / volume;
    const double virial = expected.sums.virial / (3.0 * volume);
    const double tail = expected.tail_pressure;
    const double noise = tolerance * (kinetic + std::abs(virial));
    const double others = (static_cast<double>(expected.atoms) - 1.0) / static_cast<double>(expected.atoms);
    return best_of(
        found, right, noise,
        and_tails(
            {{right - tail, "missing tail: the pressure is without its tail correction"},
             {right + tail, "tail twice: the pressure has its tail correction twice"},
             {right + (others - 1.0) * tail,
              "tail of N - 1: the tail correction of the pressure is that of N (N - 1) pairs"},
             {right + (others * others - 1.0) * tail,
              "tail of N - 1: the tail correction of the pressure is that of N - 1 atoms"},
             {ideal + virial + tail,
              "3N against 3N-3: the pressure is rho T + W/(3 V), as a run of ljmd has it, where (2 K + W)/(3 V) is "
              "asked "
              "for; no mistake in itself if T is that of the same moment"},
             {ideal + virial,
              "missing tail, 3N against 3N-3: the pressure is rho T + W/(3 V) without its tail correction"},
             {kinetic - virial + tail, "virial: the pressure has it with the wrong sign"},
             {kinetic + 0.5 * virial + tail, "virial: the pressure has half of it"},
             {kinetic + 2.0 * virial + tail, "virial: the pressure has it twice"},
             {kinetic + virial_of_atoms(fluid, expected.sums.forces) / (3.0 * volume) + tail, virial_of_atoms_words},
             {0.5 * kinetic + virial + tail, "pressure: it has K, where it is to have 2 K"},
             {2.0 * kinetic + virial + tail, "pressure: it has 4 K, where it is to have 2 K"},
             {3.0 * (kinetic + virial) + tail, "pressure: it is (2 K + W)/V, where it is to be (2 K + W)/(3 V)"},
             {kinetic + 3.0 * virial + tail, "pressure: W is divided by V, where it is to be divided by 3 V"},
             {ideal + 3.0 * virial + tail, "pressure: W is divided by V, where it is to be divided by 3 V"},
             {3.0 * kinetic + virial + tail, "pressure: 2 K is divided by V, where it is to be divided by 3 V"},
             {virial + tail, "pressure: the kinetic part is left out"}},
            right - tail, wrong_tails(fluid, expected, true)));
}

}  // namespace

std::vector<std::string> diagnose_point(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                                        double tolerance) {
    const AnswerParts parts(expected, answer, tolerance);
    std::vector<std::string> words;
    const auto note = [&](const std::optional<std::string>& sentence) {
        if (sentence && std::ranges::find(words, *sentence) == words.end()) {
            words.push_back(*sentence);
        }
    };
    const bool energy = parts.energy_is_wrong();
    const bool virial = parts.virial_is_wrong();
    const bool forces = parts.forces_are_wrong();
    if (virial || forces || energy) {
        note(joint_mistake(fluid, expected, answer, tolerance));
    }
    if (words.empty()) {
        if (energy) note(wrong_energy(fluid, expected, answer, tolerance));
        if (virial) note(wrong_virial(fluid, expected, answer, tolerance));
        if (forces) note(wrong_forces(expected, answer, tolerance));
    }
    if (answer.kinetic_energy) note(wrong_kinetic_energy(expected, answer, tolerance));
    if (answer.temperature) note(wrong_temperature(expected, answer, tolerance));
    if (answer.pressure && words.empty()) note(wrong_pressure(fluid, expected, answer, tolerance));
    return words;
}

}  // namespace ljmd
