#include "judge/joint_diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

#include "judge/explanations.hpp"
#include "judge/odd_pairs.hpp"
#include "judge/summed_pairs.hpp"

namespace ljmd {

namespace {

/// Cutoffs and scales of length are looked for up to these factors.
constexpr double farthest = 1.3;
constexpr double largest_scale = 1.2;
constexpr double largest_scale_of_edges = 1.02;

double squared_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - b[i]).squaredNorm();
    }
    return sum;
}

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i].dot(b[i]);
    }
    return sum;
}

/// An answer that is to be explained.
class Case {
  public:
    Case(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer, double tolerance)
        : fluid_(fluid),
          expected_(expected),
          answer_(answer),
          tolerance_(tolerance),
          parts_(expected, answer, tolerance),
          range_(farthest * fluid.potential.cutoff().radius),  // an engine takes nearest images beyond L/2, too
          pairs_(fluid.positions, fluid.edges, range_) {}

    /// The mistake that explains most.
    [[nodiscard]] std::optional<std::string> joint() {
        epsilon();
        missing_images();
        other_cutoff();
        sigma();
        other_truncations();
        other_forces();
        left_out_neighbours();
        offer_odd_pairs(fluid_, expected_, answer_, parts_, tolerance_, known_);
        offer_digits_of_start(fluid_, parts_, known_);
        other_edges();
        return known_.best();
    }

  private:
    void offer(const PairSums& sums, const std::string& words) {
        if (const std::optional<double> left = parts_.unexplained(sums)) {
            known_.offer(*left, words);
        }
    }

    void epsilon() {
        const std::optional<double> c = parts_.factor();
        if (c && std::isfinite(*c)) {
            offer(pairs_.sums(fluid_.potential, {.epsilon = *c}),
                  fmt::format(
                      "epsilon off: energy, virial and forces are those of an epsilon of {:.10g}, where it is 1", *c));
        }
    }

    /// Each direction may miss its images on both sides, on one of them or on none.
    void missing_images() {
        using Sides = std::array<bool, 2>;
        static constexpr std::array<Sides, 4> ways{{{false, false}, {true, true}, {true, false}, {false, true}}};
        const std::size_t count = ways.size();
        for (std::size_t k = 1; k < count * count * count; ++k) {
            const SummedPairs::MissedImages missed{ways[k % count], ways[k / count % count], ways[k / count / count]};
            const bool one_sided = std::ranges::any_of(missed, [](const Sides& sides) { return sides[0] != sides[1]; });
            for (const bool alone : {false, true}) {
                if (one_sided || !alone) {
                    offer(pairs_.sums(fluid_.potential, {.missed = missed, .each_atom_alone = alone}),
                          in_words(missed, alone));
                }
            }
        }
    }

    [[nodiscard]] static std::string in_words(const SummedPairs::MissedImages& missed, bool alone) {
        if (std::ranges::all_of(missed, [](const auto& sides) { return sides[0] && sides[1]; })) {
            return "missing image: pairs that are near each other through a wall of the box are left out, all others "
                   "are right";
        }
        std::vector<std::string> where;
        const auto tell = [&](const auto& sides, char axis) {
            if (sides[0] && sides[1]) {
                where.push_back(fmt::format("along {}", axis));
            } else if (sides[0] || sides[1]) {
                where.push_back(fmt::format("where {0}_i - {0}_j {1}L/2{2}", axis, sides[1] ? "> " : "< -",
                                            alone ? ", on atom i" : " for i < j"));
            }
        };
        if (missed[0] == missed[1] && missed[0] == missed[2]) {
            tell(missed[0], 'r');  // in any direction
        } else {
            for (std::size_t k = 0; k < missed.size(); ++k) {
                tell(missed[k], "xyz"[k]);
            }
        }
        return fmt::format(
            "missing image: pairs that are near each other through a wall of the box are left out {}, all others are "
            "right",
            fmt::join(where, " and "));
    }

    /// Distance of an answer from the sums, for a search: forces if there are any.
    [[nodiscard]] double distance(const PairSums& sums) const {
        if (!answer_.forces.empty()) {
            return parts_.forces(sums).off;
        }
        return answer_.virial ? parts_.virial(sums).off : parts_.energy(sums).off;
    }

    void sigma() {
        const double cutoff = fluid_.potential.cutoff().radius;
        for (const bool moves : {false, true}) {
            // u(r/s) within rc: the cutoff in units of s sigma is rc/s.
            const auto potential = [&](double s) {
                return moves ? fluid_.potential : with_cutoff(fluid_.potential, cutoff / s);
            };
            const auto sums = [&](double s) { return pairs_.sums(potential(s), {.sigma = s}); };
            const double s = best_scale([&](double scale) { return distance(sums(scale)); }, 0.8,
                                        moves ? std::min(largest_scale, range_ / cutoff) : largest_scale);
            offer(sums(s),
                  fmt::format("sigma off: energy, virial and forces are those of a sigma of {:.10g}, where it is "
                              "1{}",
                              s, moves ? ", and the cutoff with it" : ""));
        }
    }

    /// The box is larger or smaller, in all directions or in one; the atoms are where they are.
    void other_edges() {
        const SummedPairs pairs(fluid_.positions, fluid_.edges, largest_scale_of_edges * range_);
        for (int axis = -1; axis < 3; ++axis) {
            const auto sums = [&](double s) {
                const Vec3 by = (s - 1.0) * fluid_.edges;
                return pairs.with_longer_edges(axis < 0 ? by : Vec3(by[axis] * Vec3::Unit(axis)))
                    .sums(fluid_.potential);
            };
            const double s = best_scale([&](double scale) { return distance(sums(scale)); },
                                        2.0 - largest_scale_of_edges, largest_scale_of_edges);
            offer(sums(s),
                  fmt::format("edges of the box: energy, virial and forces are those of a box whose {} {:.8g} "
                              "times as long",
                              axis < 0 ? std::string("edges are") : fmt::format("edge {} is", "xyz"[axis]), s));
        }
    }

    /// Ours with the parts of other sums.
    [[nodiscard]] PairSums with_energy_of(const PairSums& other) const {
        return {other.potential_energy, expected_.sums.virial, expected_.sums.forces};
    }
    [[nodiscard]] PairSums with_forces_of(const PairSums& other) const {
        return {expected_.sums.potential_energy, other.virial, other.forces};
    }

    /// Energy, or forces, or both are cut off in another way. That an energy is shifted or not is told elsewhere.
    void other_truncations() {
        const PairPotential& potential = fluid_.potential;
        const std::string& ours = potential.truncation();
        for (const char* theirs : {"cut", "shifted", "force-shifted"}) {
            if (ours == theirs ||
                (ours != "force-shifted" && ours != "switched" && std::string_view(theirs) != "force-shifted")) {
                continue;
            }
            const PairSums sums = pairs_.sums(
                PairPotential::make(potential.formula(), theirs, potential.cutoff(), potential.parameters()));
            const auto words = [&](const char* what, const char* rest) {
                return fmt::format("truncation: {} of a potential that is {}, where it is to be {}{}", what, theirs,
                                   ours, rest);
            };
            offer(with_energy_of(sums), words("the energy is that", "; forces are right"));
            offer(with_forces_of(sums), words("forces and virial are those", "; the energy is right"));
            offer(sums, words("energy, virial and forces are those", ""));
        }
    }

    /// Forces of a wrong formula, whose virial is theirs, or right.
    void other_forces() {
        const PairPotential& potential = fluid_.potential;
        const auto offer_forces = [&](const std::function<double(const SummedPairs::Pair&)>& w, const char* words) {
            PairSums sums = pairs_.sums_of([&](const SummedPairs::Pair& pair) {
                return PairTerm<double>{0.0, w(pair)};
            });
            offer(with_forces_of(sums), words);
            sums.virial = expected_.sums.virial;
            offer(with_forces_of(sums), words);
        };
        const auto times_power = [&](int power) {
            return [&potential, power](const SummedPairs::Pair& pair) {
                return potential(pair.distance).w * std::pow(pair.distance, power);
            };
        };
        offer_forces(times_power(1), "forces: r_ij is not divided by r; f_ij = -u'(r) r_ij/r");
        offer_forces(times_power(2), "forces: they are r^2 times too large; f_ij = -u'(r) r_ij/r");
        offer_forces(times_power(-1), "forces: they are divided by r once too often; f_ij = -u'(r) r_ij/r");
        offer_forces(times_power(-2), "forces: they are divided by r^2 once too often; f_ij = -u'(r) r_ij/r");
        const std::string& truncation = potential.truncation();
        if (potential.formula() != "lennard-jones" || (truncation != "cut" && truncation != "shifted")) {
            return;
        }
        const auto by_powers = [&](double a, double b) {  // a r^-12 + b r^-6, of the derivative
            return [=, radius = potential.cutoff().radius](const SummedPairs::Pair& pair) {
                const double s2 = 1.0 / (pair.distance * pair.distance);
                const double s6 = s2 * s2 * s2;
                return pair.distance < radius ? (a * s6 * s6 + b * s6) * s2 : 0.0;
            };
        };
        offer_forces(by_powers(24.0, -24.0), "forces: a 2 is forgotten in 24 (2 r^-12 - r^-6) r_ij/r^2");
        offer_forces(by_powers(48.0, -48.0), "forces: a 1/2 is forgotten in 48 (r^-12 - r^-6/2) r_ij/r^2");
        offer_forces(by_powers(48.0, 24.0), "forces: the sign of r^-6 is wrong in 24 (2 r^-12 - r^-6) r_ij/r^2");
    }

    /// A loop over j that begins one too late.
    void left_out_neighbours() {
        offer(pairs_.sums_of([&](const SummedPairs::Pair& pair) {
            return pair.j == pair.i + 1 ? PairTerm<double>{} : fluid_.potential(pair.distance);
        }),
              "neighbouring ids: all pairs of the ids i and i + 1 are left out, all others are right");
    }

    /// The scale of length with the smallest distance: by a grid, then by golden section.
    template <class Distance>
    [[nodiscard]] static double best_scale(const Distance& off, double lowest, double highest) {
        constexpr int steps = 40;
        const double width = (highest - lowest) / steps;
        double best = 1.0;
        double smallest = off(1.0);
        for (int k = 0; k <= steps; ++k) {
            const double s = lowest + k * width;
            if (const double here = off(s); here < smallest) {
                smallest = here;
                best = s;
            }
        }
        return golden_section(off, best - width, std::min(best + width, highest));
    }

    void other_cutoff() {
        const double cutoff = fluid_.potential.cutoff().radius;
        const auto sums = [&](double radius) { return pairs_.sums(with_cutoff(fluid_.potential, radius)); };
        const std::string& truncation = fluid_.potential.truncation();
        const bool is_stepped = truncation == "cut" || truncation == "shifted";
        const auto [low, high] = is_stepped ? bracket_of_cutoff() : bracket_by_grid(sums);
        const double refined =
            truncation == "cut" ? 0.5 * (low + high)
                                : golden_section(
                                      [&](double radius) {
                                          const PairSums found = sums(radius);
                                          return answer_.potential_energy ? parts_.energy(found).off : distance(found);
                                      },
                                      low, high);
        if (std::abs(refined - cutoff) > 1e-12) {
            offer(sums(refined),
                  fmt::format("other cutoff: energy, virial and forces are those of a cutoff {}, where it is {:g}",
                              is_stepped ? fmt::format("between {:.8g} and {:.8g}", low, high)
                                         : fmt::format("of {:.8g}", refined),
                              cutoff));
        }
    }

    /// Forces of a plain cut or shift change with the cutoff where a pair comes in: pairs are added one by one in the
    /// order of their distances, and those distances are returned between which the answer is met best.
    [[nodiscard]] std::pair<double, double> bracket_of_cutoff() const {
        std::vector<SummedPairs::Pair> sorted = pairs_.pairs();
        std::ranges::sort(sorted, {}, &SummedPairs::Pair::distance);
        std::vector<Vec3> rest = answer_.forces;  // of the forces, when the forces of the pairs so far are taken off
        double squares = rest.empty() ? 0.0 : dot(rest, rest);
        double virial = answer_.virial.value_or(0.0);
        double smallest = std::numeric_limits<double>::infinity();
        std::size_t last = 0;
        for (std::size_t k = 0; k < sorted.size(); ++k) {
            const SummedPairs::Pair& pair = sorted[k];
            const double w = fluid_.potential.untruncated(pair.distance).w;
            virial -= w * pair.distance * pair.distance;
            if (!rest.empty()) {
                squares -= rest[pair.i].squaredNorm() + rest[pair.j].squaredNorm();
                rest[pair.i] -= w * pair.separation;
                rest[pair.j] += w * pair.separation;
                squares += rest[pair.i].squaredNorm() + rest[pair.j].squaredNorm();
            }
            const double off = rest.empty() ? std::abs(virial) : squares;
            if (off < smallest) {
                smallest = off;
                last = k;
            }
        }
        return sorted.empty()
                   ? std::pair(range_, range_)
                   : std::pair(sorted[last].distance, last + 1 < sorted.size() ? sorted[last + 1].distance : range_);
    }

    template <class Sums>
    [[nodiscard]] std::pair<double, double> bracket_by_grid(const Sums& sums) const {
        constexpr int steps = 60;
        const double least =
            std::max(0.6 * fluid_.potential.cutoff().radius, fluid_.potential.cutoff().switch_start * 1.0001);
        const double width = (range_ - least) / steps;
        double best = least;
        double smallest = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= steps; ++k) {
            const double radius = least + k * width;
            if (const double here = distance(sums(radius)); here < smallest) {
                smallest = here;
                best = radius;
            }
        }
        return {std::max(least, best - width), std::min(range_, best + width)};
    }

    template <class F>
    [[nodiscard]] static double golden_section(const F& f, double low, double high) {
        constexpr double golden = 0.6180339887498949;
        for (int k = 0; k < 70; ++k) {
            const double left = high - golden * (high - low);
            const double right = low + golden * (high - low);
            (f(left) < f(right) ? high : low) = f(left) < f(right) ? right : left;
        }
        return 0.5 * (low + high);
    }

    const Fluid& fluid_;
    const ExpectedPoint& expected_;
    const PointAnswer& answer_;
    double tolerance_;
    AnswerParts parts_;
    double range_;
    SummedPairs pairs_;
    Explanations known_{1.0, 0.0, unexplained_of_point};  ///< in parts of the difference
};

}  // namespace

AnswerPart AnswerParts::energy(const PairSums& sums) const {
    return {std::abs(*answer_.potential_energy - sums.potential_energy - expected_.tail_energy),
            tolerance_ * std::abs(expected_.sums.potential_energy)};
}

AnswerPart AnswerParts::virial(const PairSums& sums) const {
    return {std::abs(*answer_.virial - sums.virial),
            tolerance_ * (2.0 * expected_.kinetic_energy + std::abs(expected_.sums.virial))};
}

AnswerPart AnswerParts::forces(const PairSums& sums) const {
    return {std::sqrt(squared_distance(answer_.forces, sums.forces)),
            tolerance_ * std::sqrt(dot(expected_.sums.forces, expected_.sums.forces))};
}

std::optional<double> AnswerParts::unexplained(const PairSums& sums) const {
    int numbers = 0;
    bool some = false;
    double most = 0.0;
    const auto count = [&](const AnswerPart& with, const AnswerPart& without, int more) {
        numbers += more;
        some = some || without.is_wrong();
        const double counted = with.off <= with.noise ? 0.0 : with.off / std::max(without.off, without.noise);
        most = larger_or_nan(most, counted);
    };
    if (answer_.potential_energy) count(energy(sums), energy(expected_.sums), 1);
    if (answer_.virial) count(virial(sums), virial(expected_.sums), 1);
    if (!answer_.forces.empty()) count(forces(sums), forces(expected_.sums), 2);
    return most <= unexplained_of_point && some && numbers > 1 ? std::optional(most) : std::nullopt;
}

std::optional<double> AnswerParts::factor() const {
    if (!answer_.forces.empty()) {
        return dot(answer_.forces, expected_.sums.forces) / dot(expected_.sums.forces, expected_.sums.forces);
    }
    return answer_.virial ? std::optional(*answer_.virial / expected_.sums.virial) : std::nullopt;
}

std::optional<std::string> joint_mistake(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                                         double tolerance) {
    return Case(fluid, expected, answer, tolerance).joint();
}

}  // namespace ljmd
