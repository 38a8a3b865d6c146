#include "judge/odd_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "judge/few_digits.hpp"
#include "judge/missing_pairs.hpp"

namespace ljmd {

namespace {

/// Atoms that are tried as the odd one: those with the largest differences.
constexpr std::size_t most_odd_atoms = 3;

/// Starts of few digits are tried where all pairs are looked at in a second.
constexpr std::size_t most_atoms_of_a_start = 3000;

/// Sums with a part of one pair taken off.
void take_off_pair(PairSums& sums, const SummedPairs::Pair& pair, const PairPotential& potential, double part) {
    const PairTerm<double> term = potential(pair.distance);
    sums.potential_energy -= part * term.u;
    sums.virial -= part * term.w * pair.distance * pair.distance;
    sums.forces[pair.i] -= part * term.w * pair.separation;
    sums.forces[pair.j] += part * term.w * pair.separation;
}

void offer_missing_pairs(const MissingPairs& lacking, const PairPotential& potential, const PairSums& right,
                         const AnswerParts& parts, Explanations& known) {
    const std::vector<SummedPairs::Pair> missing = lacking.of_any();
    if (missing.empty()) {
        return;
    }
    PairSums sums = right;
    for (const SummedPairs::Pair& pair : missing) {
        take_off_pair(sums, pair, potential, 1.0);
    }
    if (const auto left = parts.unexplained(sums)) {
        known.offer(*left,
                    fmt::format("missing pair: {} pair{} within the cutoff {} left out, of the ids {} and {}{}: pairs "
                                "that are excluded, as bonded ones are, or that a list loses",
                                missing.size(), missing.size() == 1 ? "" : "s", missing.size() == 1 ? "is" : "are",
                                missing.front().i + 1, missing.front().j + 1, missing.size() == 1 ? "" : " for one"));
    }
}

/// All pairs of an atom c times as strong, by least squares for c.
void offer_odd_atom(const Fluid& fluid, const SummedPairs& pairs, std::size_t atom, const std::vector<Vec3>& found,
                    const PairSums& right, const AnswerParts& parts, Explanations& known) {
    PairSums without = right;
    for (const SummedPairs::Pair& pair : pairs.pairs()) {
        if (pair.i == atom || pair.j == atom) {
            take_off_pair(without, pair, fluid.potential, 1.0);
        }
    }
    double along = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Vec3 of_atom = right.forces[i] - without.forces[i];
        along += of_atom.dot(found[i] - without.forces[i]);
        squares += of_atom.squaredNorm();
    }
    if (!(squares > 0.0)) {
        return;
    }
    const double c = along / squares;
    PairSums sums = without;
    sums.potential_energy += c * (right.potential_energy - without.potential_energy);
    sums.virial += c * (right.virial - without.virial);
    for (std::size_t i = 0; i < found.size(); ++i) {
        sums.forces[i] += c * (right.forces[i] - without.forces[i]);
    }
    if (const auto left = parts.unexplained(sums)) {
        constexpr double none = 1e-6;
        known.offer(*left,
                    std::abs(c) < none
                        ? fmt::format("one atom: the one of id {} acts on no other", atom + 1)
                        : fmt::format("one atom: all pairs of the one of id {} are {:.8g} times as strong as they "
                                      "are to be",
                                      atom + 1, c));
    }
}

std::vector<Vec3> rounded(std::vector<Vec3> vectors, const Rounding& way) {
    for (Vec3& v : vectors) {
        v = v.unaryExpr(way.round);
    }
    return vectors;
}

}  // namespace

void offer_odd_pairs(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                     const AnswerParts& parts, double tolerance, Explanations& known) {
    if (answer.forces.empty()) {
        return;
    }
    const std::vector<Vec3>& right = expected.sums.forces;
    double squares = 0.0;
    for (const Vec3& f : right) {
        squares += f.squaredNorm();
    }
    const double noise = tolerance * std::sqrt(squares / static_cast<double>(right.size()));
    const MissingPairs lacking(fluid.positions, answer.forces, right, fluid.edges, fluid.potential, noise);
    std::vector<std::size_t> order(right.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, std::greater{},
                      [&](std::size_t i) { return (answer.forces[i] - right[i]).squaredNorm(); });
    if (lacking.wrong_atoms() == 1) {
        PairSums sums = expected.sums;
        sums.forces = answer.forces;
        if (const auto left = parts.unexplained(sums)) {
            known.offer(*left,
                        fmt::format("one atom: the force on the one of id {} alone is wrong", order.front() + 1));
        }
        return;
    }
    offer_missing_pairs(lacking, fluid.potential, expected.sums, parts, known);
    const SummedPairs pairs(fluid.positions, fluid.edges, fluid.potential.cutoff().radius);
    for (std::size_t k = 0; k < std::min(most_odd_atoms, order.size()); ++k) {
        offer_odd_atom(fluid, pairs, order[k], answer.forces, expected.sums, parts, known);
    }
}

void offer_digits_of_start(const Fluid& fluid, const AnswerParts& parts, Explanations& known) {
    if (fluid.positions.size() > most_atoms_of_a_start) {
        return;
    }
    const double cutoff = fluid.potential.cutoff().radius;
    const auto offer = [&](const std::vector<Vec3>& positions, const Vec3& edges, const std::string& words) {
        if (cutoff <= 0.5 * edges.minCoeff()) {
            if (const auto left = parts.unexplained(SummedPairs(positions, edges, cutoff).sums(fluid.potential))) {
                known.offer(*left, words);
            }
        }
    };
    for (const Rounding& way : roundings()) {
        offer(rounded(fluid.positions, way), fluid.edges,
              fmt::format("digits of the start: energy, virial and forces are those of positions with {}", way.words));
        const Vec3 edges = fluid.edges.unaryExpr(way.round);
        if (edges != fluid.edges) {
            offer(
                fluid.positions, edges,
                fmt::format("edges of the box: energy, virial and forces are those of edges with {}: {:.10g}, {:.10g}, "
                            "{:.10g}",
                            way.words, edges[0], edges[1], edges[2]));
        }
    }
}

}  // namespace ljmd
