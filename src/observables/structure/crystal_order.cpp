#include "observables/structure/crystal_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "execution/loops.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

namespace {

constexpr double weakest_peak = 0.1;      // S(G)/N of the shortest G in a crystal; 0.6 at melting, 3/N in a fluid
constexpr double notable_vacancy = 1e-3;  // share of vacant sites that a remark tells

constexpr Index displacement = 0;
constexpr Index relative_displacement = 1;
constexpr Index vacancy = 2;
constexpr Index first_family = 3;

// The columns of a family.
constexpr Index wave_number = 0;
constexpr Index cosine = 1;
constexpr Index intensity = 2;
constexpr Index of_family = 3;

Index columns_of(Index families) {
    return first_family + of_family * families;
}

constexpr const char* no_crystal =
    "the crystal that was asked for is not there: its Bragg peak is below a tenth of that at rest";

}  // namespace

std::vector<CrystalOrder::Family> CrystalOrder::families_of(Lattice lattice, Index count) {
    std::vector<Family> families;
    const int largest = static_cast<int>(count) + 1;  // (n 0 0), or (2n 0 0) of fcc, is never beyond the n-th family
    const auto order = [](const Family& family) { return family.miller.squaredNorm(); };
    for (int h = 1; h <= 2 * largest; ++h) {
        for (int k = 0; k <= h; ++k) {
            for (int l = 0; l <= k; ++l) {
                const bool alike = (h + k) % 2 == 0 && (h + l) % 2 == 0;
                if (lattice != Lattice::fcc || alike) {
                    families.push_back({Vec3(h, k, l), {}});
                }
            }
        }
    }
    std::ranges::stable_sort(families, {}, order);
    families.resize(static_cast<std::size_t>(count));
    for (Family& family : families) {
        Vec3 numbers = family.miller.reverse();  // ascending
        do {
            for (int signs = 0; signs < 8; ++signs) {
                const Vec3 sign((signs & 1) != 0 ? -1.0 : 1.0, (signs & 2) != 0 ? -1.0 : 1.0,
                                (signs & 4) != 0 ? -1.0 : 1.0);
                // + 0 makes a zero positive, so that each vector is found once; of G and -G the one after the other.
                const Vec3 vector = numbers.cwiseProduct(sign).array() + 0.0;
                const auto is = [](const Vec3& wanted) { return [&](const Vec3& each) { return each == wanted; }; };
                if (std::ranges::none_of(family.members, is(vector)) &&
                    std::ranges::none_of(family.members, is(-vector))) {
                    family.members.push_back(vector);
                }
            }
        } while (std::next_permutation(numbers.begin(), numbers.end()));
    }
    return families;
}

CrystalOrder::CrystalOrder(const CrystalInBox& crystal, Index families, Every every)
    : crystal_(crystal),
      families_(families_of(crystal.lattice, families)),
      every_(every),
      means_(columns_of(families), Covariance::full) {}

double CrystalOrder::bytes(Index families, Index samples) {
    return BlockingAccumulator::bytes(columns_of(families), Covariance::full, samples);
}

void CrystalOrder::sample(const State& state, const Evaluation& /*evaluation*/) {
    atoms_ = state.count();
    const auto atoms = static_cast<double>(atoms_);
    const CrystalDisplacements found = crystal_displacements(state, crystal_);
    const Vec3 unit = 2.0 * std::numbers::pi * crystal_.cell(state.box()).cwiseInverse();
    const double d = crystal_.nearest_neighbours(state.box());

    std::vector<Vec3> vectors;
    for (const Family& family : families_) {
        for (const Vec3& member : family.members) {
            vectors.push_back(member.cwiseProduct(unit));
        }
    }
    const auto count = static_cast<Index>(vectors.size());
    using Sums = Eigen::VectorXd;  // cosines of all vectors, sines of all vectors, squared displacement
    const Sums sums = join_blocks(
        state.execution(), atoms_, sum_block, Sums(Sums::Zero(2 * count + 1)),
        [&](Index first, Index last) {
            Sums of_block = Sums::Zero(2 * count + 1);
            for (Index i = first; i < last; ++i) {
                const Vec3 u = found.u.col(i);
                for (Index k = 0; k < count; ++k) {
                    const double phase = vectors[static_cast<std::size_t>(k)].dot(u);
                    of_block[k] += std::cos(phase);
                    of_block[count + k] += std::sin(phase);
                }
                of_block[2 * count] += u.squaredNorm();
            }
            return of_block;
        },
        [](Sums& sum, const Sums& of_block) { sum += of_block; });

    Eigen::VectorXd sample(means_.width());
    sample[displacement] = sums[2 * count] / atoms;
    sample[relative_displacement] = sample[displacement] / (d * d);
    sample[vacancy] = static_cast<double>(found.vacant) / static_cast<double>(crystal_.sites());
    Index at = 0;
    Index column = first_family;
    for (const Family& family : families_) {
        const auto members = static_cast<Index>(family.members.size());
        double length = 0.0;
        for (Index k = at; k < at + members; ++k) {
            length += vectors[static_cast<std::size_t>(k)].norm();
        }
        const auto cosines = sums.segment(at, members);
        const auto sines = sums.segment(count + at, members);
        sample[column + wave_number] = length / static_cast<double>(members);
        sample[column + cosine] = cosines.mean() / atoms;
        sample[column + intensity] =
            (cosines.squaredNorm() + sines.squaredNorm()) / (atoms * static_cast<double>(members));
        at += members;
        column += of_family;
    }
    means_.add(sample);
}

std::vector<DataTable> CrystalOrder::tables() const {
    if (means_.samples() == 0) {
        return {};
    }
    DataTable table{
        "bragg",
        {"k", "miller_h", "miller_k", "miller_l", "vectors", "S", "S_standard_error", "debye_waller_factor",
         "debye_waller_factor_standard_error", "debye_waller_gaussian", "debye_waller_gaussian_standard_error"},
        {}};
    const Eigen::VectorXd mean = means_.mean();
    const double u2 = mean[displacement];
    Index column = first_family;
    for (const Family& family : families_) {
        const double g = mean[column + wave_number];
        const double amplitude = mean[column + cosine];
        const Estimate s = means_.estimate(column + intensity);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(means_.width());
        gradient[column + cosine] = 2.0 * amplitude;
        const Estimate factor = means_.estimate(amplitude * amplitude, gradient);
        const double of_gauss = std::exp(-g * g * u2 / 3.0);
        gradient.setZero();
        gradient[displacement] = -g * g / 3.0 * of_gauss;
        gradient[column + wave_number] = -2.0 * g * u2 / 3.0 * of_gauss;
        const Estimate gaussian = means_.estimate(of_gauss, gradient);
        table.rows.push_back({g, family.miller[0], family.miller[1], family.miller[2],
                              static_cast<double>(family.members.size()), s.mean, s.standard_error, factor.mean,
                              factor.standard_error, gaussian.mean, gaussian.standard_error});
        column += of_family;
    }
    return {table};
}

std::vector<ObservableAverage> CrystalOrder::observables() const {
    if (means_.samples() == 0) {
        return {};
    }
    ObservableAverage u2 = average_of("site_displacement", std::nullopt, no_crystal);
    ObservableAverage by_peak = average_of("site_displacement_debye_waller", std::nullopt, no_crystal);
    ObservableAverage lindemann = average_of("lindemann_ratio", std::nullopt, no_crystal);
    ObservableAverage vacant = average_of("vacant_sites", std::nullopt, no_crystal);

    const Eigen::VectorXd mean = means_.mean();
    const auto with_slope = [&](double value, const std::vector<std::pair<Index, double>>& slopes) {
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(means_.width());
        for (const auto& slope : slopes) {
            gradient[slope.first] = slope.second;
        }
        return means_.estimate(value, gradient);
    };
    const double atoms = static_cast<double>(atoms_);
    const Estimate peak = with_slope(mean[first_family + intensity] / atoms, {{first_family + intensity, 1.0 / atoms}});
    const double g = mean[first_family + wave_number];
    const double amplitude = mean[first_family + cosine];
    if (peak.mean > weakest_peak && amplitude > 0.0) {
        const double ratio = std::sqrt(mean[relative_displacement]);
        const double logarithm = std::log(amplitude);
        u2.estimate = means_.estimate(displacement);
        by_peak.estimate =
            with_slope(-6.0 / (g * g) * logarithm, {{first_family + cosine, -6.0 / (g * g * amplitude)},
                                                    {first_family + wave_number, 12.0 * logarithm / (g * g * g)}});
        // A crystal at rest has no slope here, and no error either.
        lindemann.estimate = with_slope(ratio, {{relative_displacement, ratio > 0.0 ? 0.5 / ratio : 0.0}});
        vacant.estimate = means_.estimate(vacancy);
        for (ObservableAverage* each : {&u2, &by_peak, &lindemann, &vacant}) {
            each->remark.clear();
        }
        if (mean[vacancy] > notable_vacancy) {
            u2.remark = fmt::format("{:.2g} % of the sites are vacant: an atom counts from the nearest one",
                                    100.0 * mean[vacancy]);
        }
    }
    return {u2, by_peak, lindemann, average_of("bragg_peak", peak), vacant};
}

}  // namespace ljmd
