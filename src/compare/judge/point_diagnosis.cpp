#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "explanations.hpp"
#include "joint_diagnosis.hpp"
#include "ljmd/compare/judge/net_force.hpp"
#include "ljmd/compare/judge/point_judgement.hpp"
#include "ljmd/potentials/tail_correction.hpp"

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

std::optional<std::string> wrong_energy(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                                        double tolerance) {
    const double found = *answer.potential_energy;
    const double right = expected.potential_energy();
    const double pairs = expected.sums.potential_energy;
    const double tail = expected.tail_energy;
    const double noise = tolerance * std::abs(pairs);
    const auto atoms = static_cast<double>(expected.atoms);
    const double cutoff = fluid.potential.cutoff().radius;
    const double step = static_cast<double>(NearPairs(fluid.positions, fluid.edges, cutoff).pairs().size()) *
                        fluid.potential.untruncated(cutoff).u;
    const double full_tail =
        atoms * TailCorrection(PairPotential::make(fluid.potential.formula(), "cut", fluid.potential.cutoff(),
                                                   fluid.potential.parameters()))
                    .energy(atoms / expected.volume);
    const double others = (atoms - 1.0) / atoms;
    return best_of(
        found, right, noise,
        {{right - step, "shifted energy: the potential is shifted to zero at the cutoff, where it is to be cut"},
         {right + step, "shifted energy: the potential is not shifted to zero at the cutoff, as it is to be"},
         {pairs - step,
          "shifted energy and missing tail: the potential is shifted to zero at the cutoff and has no tail correction"},
         {pairs, "missing tail: the tail correction is left out, the pairs are right"},
         {pairs + 2.0 * tail, "tail twice: the tail correction is added twice, the pairs are right"},
         {pairs + others * tail, "tail of N - 1: the tail correction is that of N - 1 atoms, or N (N - 1) pairs"},
         {pairs + others * others * tail, "tail of N - 1: the tail correction is that of N - 1 atoms at their density"},
         {pairs + tail / atoms,
          "tail of one atom: the tail correction is that of one atom, where it is to be that of all"},
         {pairs + full_tail, "tail too many: a tail correction is added, which the problem does not have"},
         {right / atoms, "energy of one atom: the energy is divided by the number of atoms"},
         {2.0 * pairs + tail, "pairs twice: every pair is counted twice in the energy"},
         {2.0 * right, "pairs twice: every pair is counted twice in the energy"},
         {0.5 * pairs + tail, "half the pairs: the energy of the pairs is half of what it is to be"},
         {-right, "sign: the energy has the wrong sign"},
         {right + expected.kinetic_energy, "total energy: the kinetic energy is in the potential energy"}});
}

std::optional<std::string> wrong_virial(const ExpectedPoint& expected, const PointAnswer& answer, double tolerance) {
    const double found = *answer.virial;
    const double right = expected.sums.virial;
    const double noise = tolerance * (2.0 * expected.kinetic_energy + std::abs(right));
    return best_of(found, right, noise,
                   {{-right, "virial: the sign is wrong; W is the sum of r . f, positive where atoms repel each other"},
                    {0.5 * right, "virial: half of it; every pair counts once with r . f"},
                    {-0.5 * right, "virial: minus half of it, the virial of Clausius; W is the sum of r . f"},
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
                    {kinetic / (3.0 * atoms - 3.0), "temperature: it is K/(3 N - 3), half of it"}});
}

std::optional<std::string> wrong_pressure(const ExpectedPoint& expected, const PointAnswer& answer, double tolerance) {
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
        {{right - tail, "missing tail: the pressure is without its tail correction"},
         {right + tail, "tail twice: the pressure has its tail correction twice"},
         {right + (others - 1.0) * tail,
          "tail of N - 1: the tail correction of the pressure is that of N (N - 1) pairs"},
         {right + (others * others - 1.0) * tail,
          "tail of N - 1: the tail correction of the pressure is that of N - 1 atoms"},
         {ideal + virial + tail,
          "3N against 3N-3: the pressure is rho T + W/(3 V), as a run of ljmd has it, where (2 K + W)/(3 V) is asked "
          "for; "
          "no mistake in itself"},
         {ideal + virial, "missing tail, 3N against 3N-3: the pressure is rho T + W/(3 V) without its tail correction"},
         {kinetic - virial + tail, "virial: the pressure has it with the wrong sign"},
         {kinetic + 0.5 * virial + tail, "virial: the pressure has half of it"},
         {virial + tail, "pressure: the kinetic part is left out"}});
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
        if (virial) note(wrong_virial(expected, answer, tolerance));
        if (forces) note(wrong_forces(expected, answer, tolerance));
    }
    if (answer.temperature) note(wrong_temperature(expected, answer, tolerance));
    if (answer.pressure && words.empty()) note(wrong_pressure(expected, answer, tolerance));
    return words;
}

}  // namespace ljmd
