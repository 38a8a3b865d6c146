#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "ljmd/compare/judge/point_judgement.hpp"
#include "ljmd/potentials/tail_correction.hpp"

namespace ljmd {

namespace {

/// A mistake is found if it explains all of a difference but this part.
constexpr double unexplained = 1e-3;

/// Cutoffs and scales of length are looked for up to this factor.
constexpr double farthest = 1.3;
constexpr double largest_scale = 1.2;

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

double norm(const std::vector<Vec3>& a) {
    return std::sqrt(dot(a, a));
}

/// One part of an answer beside the right value: how far they are apart, and what is no difference.
struct Part {
    double off;
    double noise;
    [[nodiscard]] bool is_wrong() const { return !(off <= noise); }
};

/// An answer that is to be explained.
class Case {
  public:
    Case(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer, double tolerance)
        : fluid_(fluid),
          expected_(expected),
          answer_(answer),
          tolerance_(tolerance),
          range_(std::min(farthest * fluid.potential.cutoff().radius, 0.5 * fluid.edges.minCoeff())),
          pairs_(fluid.positions, fluid.edges, range_) {}

    [[nodiscard]] bool energy_is_wrong() const { return answer_.potential_energy && energy(expected_.sums).is_wrong(); }
    [[nodiscard]] bool virial_is_wrong() const { return answer_.virial && virial(expected_.sums).is_wrong(); }
    [[nodiscard]] bool forces_are_wrong() const { return !answer_.forces.empty() && forces(expected_.sums).is_wrong(); }

    /// The first mistake that explains energy, virial and forces together.
    [[nodiscard]] std::optional<std::string> joint() const {
        for (const auto find : {&Case::epsilon, &Case::no_images, &Case::other_cutoff, &Case::sigma}) {
            if (auto words = (this->*find)()) {
                return words;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::string> energy_alone() const;
    [[nodiscard]] std::optional<std::string> virial_alone() const;
    [[nodiscard]] std::optional<std::string> forces_alone() const;
    [[nodiscard]] std::optional<std::string> temperature_alone() const;
    [[nodiscard]] std::optional<std::string> pressure_alone() const;

  private:
    [[nodiscard]] Part energy(const PairSums& sums) const {
        return {std::abs(*answer_.potential_energy - sums.potential_energy - expected_.tail_energy),
                tolerance_ * std::abs(expected_.sums.potential_energy)};
    }
    [[nodiscard]] Part virial(const PairSums& sums) const {
        return {std::abs(*answer_.virial - sums.virial),
                tolerance_ * (2.0 * expected_.kinetic_energy + std::abs(expected_.sums.virial))};
    }
    [[nodiscard]] Part forces(const PairSums& sums) const {
        return {std::sqrt(squared_distance(answer_.forces, sums.forces)), tolerance_ * norm(expected_.sums.forces)};
    }

    /// Whether the sums made with a mistake are those of the answer. One number alone, which a parameter of a mistake
    /// can always meet, explains nothing.
    [[nodiscard]] bool explain(const PairSums& sums) const {
        int numbers = 0;
        bool some = false;
        const auto explained = [&](const Part& with, const Part& without) {
            some = some || without.is_wrong();
            return with.off <= std::max(with.noise, unexplained * without.off);
        };
        bool all = true;
        if (answer_.potential_energy) {
            all = all && explained(energy(sums), energy(expected_.sums));
            ++numbers;
        }
        if (answer_.virial) {
            all = all && explained(virial(sums), virial(expected_.sums));
            ++numbers;
        }
        if (!answer_.forces.empty()) {
            all = all && explained(forces(sums), forces(expected_.sums));
            numbers += 2;
        }
        return all && some && numbers > 1;
    }

    /// (x' . x)/(x . x) of what the answer has: the factor between forces, else virials.
    [[nodiscard]] std::optional<double> factor() const {
        if (!answer_.forces.empty()) {
            return dot(answer_.forces, expected_.sums.forces) / dot(expected_.sums.forces, expected_.sums.forces);
        }
        return answer_.virial ? std::optional(*answer_.virial / expected_.sums.virial) : std::nullopt;
    }

    [[nodiscard]] std::optional<std::string> epsilon() const {
        const std::optional<double> c = factor();
        if (!c || !std::isfinite(*c)) {
            return std::nullopt;
        }
        if (explain(pairs_.sums(fluid_.potential, {.epsilon = *c}))) {
            return fmt::format(
                "epsilon off: energy, virial and forces are those of an epsilon of {:.10g}, where it is 1", *c);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::string> no_images() const {
        if (explain(pairs_.sums(fluid_.potential, {.images = false}))) {
            return "missing image: pairs that are near each other through a wall of the box are left out, all others "
                   "are "
                   "right";
        }
        return std::nullopt;
    }

    /// Distance of an answer from the sums, for a search: forces if there are any.
    [[nodiscard]] double distance(const PairSums& sums) const {
        if (!answer_.forces.empty()) {
            return forces(sums).off;
        }
        return answer_.virial ? virial(sums).off : energy(sums).off;
    }

    [[nodiscard]] std::optional<std::string> sigma() const {
        const double cutoff = fluid_.potential.cutoff().radius;
        for (const bool moves : {false, true}) {
            // u(r/s) within rc: the cutoff in units of s sigma is rc/s.
            const auto potential = [&](double s) {
                return moves ? fluid_.potential : with_cutoff(fluid_.potential, cutoff / s);
            };
            const auto sums = [&](double s) { return pairs_.sums(potential(s), {.sigma = s}); };
            const double s = best_scale([&](double scale) { return distance(sums(scale)); },
                                        moves ? std::min(largest_scale, range_ / cutoff) : largest_scale);
            if (explain(sums(s))) {
                return fmt::format(
                    "sigma off: energy, virial and forces are those of a sigma of {:.10g}, where it is 1{}", s,
                    moves ? ", and the cutoff with it" : "");
            }
        }
        return std::nullopt;
    }

    /// The scale of length with the smallest distance: by a grid, then by golden section.
    template <class Distance>
    [[nodiscard]] static double best_scale(const Distance& off, double highest) {
        constexpr int steps = 40;
        constexpr double lowest = 0.8;
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

    [[nodiscard]] std::optional<std::string> other_cutoff() const {
        const double cutoff = fluid_.potential.cutoff().radius;
        const auto sums = [&](double radius) { return pairs_.sums(with_cutoff(fluid_.potential, radius)); };
        const std::string& truncation = fluid_.potential.truncation();
        const auto [low, high] =
            truncation == "cut" || truncation == "shifted" ? bracket_of_cutoff() : bracket_by_grid(sums);
        const double refined = truncation == "cut"
                                   ? 0.5 * (low + high)
                                   : golden_section(
                                         [&](double radius) {
                                             const PairSums found = sums(radius);
                                             return answer_.potential_energy ? energy(found).off : distance(found);
                                         },
                                         low, high);
        if (std::abs(refined - cutoff) > 1e-12 && explain(sums(refined))) {
            return fmt::format(
                "other cutoff: energy, virial and forces are those of a cutoff between {:.8g} and {:.8g}, where it is "
                "{:g}",
                low, high, cutoff);
        }
        return std::nullopt;
    }

    /// Forces of a plain cut or shift change with the cutoff where a pair comes in: pairs are added one by one in the
    /// order of their distances, and those distances are returned between which the answer is met best.
    [[nodiscard]] std::pair<double, double> bracket_of_cutoff() const {
        std::vector<NearPairs::Pair> sorted = pairs_.pairs();
        std::ranges::sort(sorted, {}, &NearPairs::Pair::distance);
        std::vector<Vec3> rest = answer_.forces;  // of the forces, when those of the pairs so far are taken off
        double squares = rest.empty() ? 0.0 : dot(rest, rest);
        double virial = answer_.virial.value_or(0.0);
        double smallest = std::numeric_limits<double>::infinity();
        std::size_t last = 0;
        for (std::size_t k = 0; k < sorted.size(); ++k) {
            const NearPairs::Pair& pair = sorted[k];
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

    /// Whether a value is this one, compared with how far it is from the right one.
    [[nodiscard]] static bool is(double value, double meant, double right, double noise) {
        return std::abs(value - meant) <= std::max(noise, unexplained * std::abs(value - right)) &&
               std::abs(value - right) > noise;
    }

    const Fluid& fluid_;
    const ExpectedPoint& expected_;
    const PointAnswer& answer_;
    double tolerance_;
    double range_;
    NearPairs pairs_;
};

std::optional<std::string> Case::energy_alone() const {
    const double found = *answer_.potential_energy;
    const double right = expected_.potential_energy();
    const double pairs = expected_.sums.potential_energy;
    const double tail = expected_.tail_energy;
    const double noise = tolerance_ * std::abs(pairs);
    const auto atoms = static_cast<double>(expected_.atoms);
    const double cutoff = fluid_.potential.cutoff().radius;
    const double step = static_cast<double>(pairs_within(pairs_, cutoff)) * fluid_.potential.untruncated(cutoff).u;
    const double full_tail =
        atoms * TailCorrection(PairPotential::make(fluid_.potential.formula(), "cut", fluid_.potential.cutoff(),
                                                   fluid_.potential.parameters()))
                    .energy(atoms / expected_.volume);
    struct Known {
        double value;
        const char* words;
    };
    for (const Known& known : std::array<Known, 10>{
             {{right - step, "shifted energy: the potential is shifted to zero at the cutoff, where it is to be cut"},
              {right + step, "shifted energy: the potential is not shifted to zero at the cutoff, as it is to be"},
              {pairs - step,
               "shifted energy and missing tail: the potential is shifted to zero at the cutoff and has no tail "
               "correction"},
              {pairs, "missing tail: the tail correction is left out, the pairs are right"},
              {pairs + 2.0 * tail, "tail twice: the tail correction is added twice, the pairs are right"},
              {pairs + full_tail, "tail too many: a tail correction is added, which the problem does not have"},
              {right / atoms, "energy of one atom: the energy is divided by the number of atoms"},
              {2.0 * pairs + tail, "pairs twice: every pair is counted twice in the energy"},
              {2.0 * right, "pairs twice: every pair is counted twice in the energy"},
              {-right, "sign: the energy has the wrong sign"}}}) {
        if (is(found, known.value, right, noise)) {
            return known.words;
        }
    }
    if (is(found, right + expected_.kinetic_energy, right, noise)) {
        return "total energy: the kinetic energy is in the potential energy";
    }
    return std::nullopt;
}

std::optional<std::string> Case::virial_alone() const {
    const double found = *answer_.virial;
    const double right = expected_.sums.virial;
    const double noise = tolerance_ * (2.0 * expected_.kinetic_energy + std::abs(right));
    struct Known {
        double value;
        const char* words;
    };
    for (const Known& known : std::array<Known, 7>{
             {{-right, "virial: the sign is wrong; W is the sum of r . f, positive where atoms repel each other"},
              {0.5 * right, "virial: half of it; every pair counts once with r . f"},
              {-0.5 * right, "virial: minus half of it, the virial of Clausius; W is the sum of r . f"},
              {2.0 * right, "virial: twice of it; every pair counts once"},
              {right / 3.0, "virial: a third of it; W is the sum of r . f, the trace of the tensor"},
              {right + 2.0 * expected_.kinetic_energy, "virial: 2 K is in it; W is of the forces alone"},
              {3.0 * expected_.volume * expected_.pressure(), "virial: it is 3 p V; W is of the forces alone"}}}) {
        if (is(found, known.value, right, noise)) {
            return known.words;
        }
    }
    return std::nullopt;
}

std::optional<std::string> Case::forces_alone() const {
    const double c = *factor();
    PairSums scaled{0.0, 0.0, expected_.sums.forces};
    for (Vec3& f : scaled.forces) {
        f *= c;
    }
    const Part off = forces(expected_.sums);
    if (forces(scaled).off > std::max(off.noise, unexplained * off.off)) {
        return std::nullopt;
    }
    return std::abs(c + 1.0) < unexplained
               ? std::string("forces: all have the wrong sign")
               : fmt::format("forces: all are {:.10g} times those of the energy's derivative", c);
}

std::optional<std::string> Case::temperature_alone() const {
    const double found = *answer_.temperature;
    const double right = expected_.temperature();
    const double kinetic = answer_.kinetic_energy.value_or(expected_.kinetic_energy);
    const auto atoms = static_cast<double>(expected_.atoms);
    if (is(found, 2.0 * kinetic / (3.0 * atoms), right, tolerance_ * right)) {
        return "3N against 3N-3: the temperature is 2 K/(3 N); at rest the centre of mass takes three degrees of "
               "freedom, "
               "T = 2 K/(3 N - 3)";
    }
    return std::nullopt;
}

std::optional<std::string> Case::pressure_alone() const {
    const double found = *answer_.pressure;
    const double right = expected_.pressure();
    const double volume = expected_.volume;
    const double kinetic = 2.0 * expected_.kinetic_energy / (3.0 * volume);
    const double ideal = static_cast<double>(expected_.atoms) * expected_.temperature() / volume;
    const double virial = expected_.sums.virial / (3.0 * volume);
    const double tail = expected_.tail_pressure;
    const double noise = tolerance_ * (kinetic + std::abs(virial));
    struct Known {
        double value;
        const char* words;
    };
    for (const Known& known : std::array<Known, 6>{
             {{right - tail, "missing tail: the pressure is without its tail correction"},
              {ideal + virial + tail,
               "3N against 3N-3: the pressure is rho T + W/(3 V), as a run of ljmd has it, where (2 K + W)/(3 V) is "
               "asked for; "
               "no mistake in itself"},
              {ideal + virial,
               "missing tail, 3N against 3N-3: the pressure is rho T + W/(3 V) without its tail correction"},
              {kinetic - virial + tail, "virial: the pressure has it with the wrong sign"},
              {kinetic + 0.5 * virial + tail, "virial: the pressure has half of it"},
              {virial + tail, "pressure: the kinetic part is left out"}}}) {
        if (is(found, known.value, right, noise)) {
            return known.words;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::string> diagnose_point(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                                        double tolerance) {
    const Case found(fluid, expected, answer, tolerance);
    std::vector<std::string> words;
    const auto note = [&](const std::optional<std::string>& sentence) {
        if (sentence && std::ranges::find(words, *sentence) == words.end()) {
            words.push_back(*sentence);
        }
    };
    const bool energy = found.energy_is_wrong();
    const bool virial = found.virial_is_wrong();
    const bool forces = found.forces_are_wrong();
    if (virial || forces || energy) {
        note(found.joint());
    }
    if (words.empty()) {
        if (energy) note(found.energy_alone());
        if (virial) note(found.virial_alone());
        if (forces) note(found.forces_alone());
    }
    if (answer.temperature) note(found.temperature_alone());
    if (answer.pressure && words.empty()) note(found.pressure_alone());
    return words;
}

}  // namespace ljmd
