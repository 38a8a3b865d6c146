#include "observables/pair_curvature.hpp"

#include <cmath>
#include <vector>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "forces/pair_force_field.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

Evaluation evaluated(State& state, const PairPotential& potential) {
    PairForceField force_field(potential, make_pair_search("all-pairs", 0.0), state.execution());
    return force_field.evaluate(state, Request::forces_and_energy);
}

/// A soft repulsion without a singularity, so that atoms may lie anywhere.
struct SoftSphere {
    PairTerm<double> operator()(const PairDistance<double>& d) const {
        const double u = 3.0 * std::exp(-d.r2);
        return {u, 2.0 * u};
    }
};

PairPotential soft(const std::string& truncation) {
    return PairPotential::custom("soft-sphere", SoftSphere{}, truncation, {1.5, 1.0});
}

/// Means over configurations of independent atoms, with their standard errors.
struct OfIndependentAtoms {
    double virial = 0.0;
    double hypervirial = 0.0;
    double hypervirial_error = 0.0;
    double laplacian = 0.0;
    double laplacian_error = 0.0;
};

OfIndependentAtoms independent_atoms(const PairPotential& potential, int configurations) {
    OfIndependentAtoms found;
    std::vector<double> differences;
    std::vector<double> laplacians;
    differences.reserve(static_cast<std::size_t>(configurations));
    laplacians.reserve(static_cast<std::size_t>(configurations));
    for (int k = 0; k < configurations; ++k) {
        State state = test::random_state(60, Box(Vec3(3.2, 3.5, 3.9)), static_cast<std::uint64_t>(k));
        const PairCurvature sums = pair_curvature(state, potential);
        const double virial = evaluated(state, potential).virial.trace();
        found.virial += virial / configurations;
        differences.push_back(sums.hypervirial - 3.0 * virial);
        laplacians.push_back(sums.laplacian);
    }
    const auto mean_and_error = [](const std::vector<double>& series, double& mean, double& error) {
        const auto n = static_cast<double>(series.size());
        double squares = 0.0;
        for (const double x : series) {
            mean += x / n;
        }
        for (const double x : series) {
            squares += (x - mean) * (x - mean);
        }
        error = std::sqrt(squares / n / n);
    };
    mean_and_error(differences, found.hypervirial, found.hypervirial_error);
    mean_and_error(laplacians, found.laplacian, found.laplacian_error);
    return found;
}

}  // namespace

TEST_CASE("the hypervirial is the change of the virial with the size of the box, the Laplacian that of the forces") {
    const std::string truncation = GENERATE("switched", "force-shifted");
    const PairPotential potential = PairPotential::lennard_jones(truncation, {2.2, 1.6});
    State state = test::shaken_crystal(3, 0.9, 0.15, 3);
    const PairCurvature found = pair_curvature(state, potential);
    const Evaluation here = evaluated(state, potential);
    CHECK(found.energy == Approx(here.potential_energy).epsilon(1e-11));

    const double h = 1e-5;
    const auto virial_at = [&](double factor) {
        State scaled = state;
        scaled.rescale_to(Box(factor * state.box().edges()));
        return evaluated(scaled, potential).virial.trace();
    };
    CHECK(found.hypervirial == Approx((virial_at(1.0 - h) - virial_at(1.0 + h)) / (2.0 * h)).epsilon(1e-5));

    double laplacian = 0.0;
    for (Index i = 0; i < state.count(); ++i) {
        for (Index axis = 0; axis < 3; ++axis) {
            const auto force_at = [&](double by) {
                State moved = state;
                moved.write_positions()(axis, i) += by;
                evaluated(moved, potential);
                return std::as_const(moved).forces()(axis, i);
            };
            laplacian += (force_at(-h) - force_at(h)) / (2.0 * h);
        }
    }
    CHECK(found.laplacian == Approx(laplacian).epsilon(1e-5));
}

TEST_CASE("among independent atoms the virial goes with 1/V and the Laplacian vanishes, also where the force jumps") {
    // <W> is proportional to 1/V, so V d<W>/dV = -<X>/3 = -<W>; the Laplacian is the divergence of a force that ends.
    // Without the term at the cutoff both would be off by 60 errors.
    const std::string truncation = GENERATE("cut", "shifted", "force-shifted", "switched");
    const OfIndependentAtoms found = independent_atoms(soft(truncation), 3000);
    CAPTURE(truncation, found.virial, found.hypervirial_error, found.laplacian_error);
    CHECK(std::abs(found.hypervirial) < 5.0 * found.hypervirial_error);
    CHECK(found.hypervirial_error < 0.01 * std::abs(found.virial));
    CHECK(std::abs(found.laplacian) < 5.0 * found.laplacian_error);
}

TEST_CASE("the energy is counted from the cutoff, and no thread changes a bit of the sums or of the state") {
    const PairPotential cut = PairPotential::lennard_jones("cut", {2.5, 0.0});
    const PairPotential shifted = PairPotential::lennard_jones("shifted", {2.5, 0.0});
    const auto sums = [&](int threads, const PairPotential& potential) {
        State state = test::shaken_crystal(5, 0.8442, 0.2, 12, test::with_threads(threads));
        const State before = state;
        const PairCurvature found = pair_curvature(state, potential);
        CHECK(std::as_const(state).positions() == before.positions());
        CHECK(std::as_const(state).ids() == before.ids());
        return std::vector<double>{found.energy, found.hypervirial, found.laplacian};
    };
    CHECK(sums(1, cut) == sums(3, cut));
    CHECK(sums(1, cut) == sums(1, shifted));
    State state = test::shaken_crystal(5, 0.8442, 0.2, 12);
    CHECK(sums(1, cut)[0] == Approx(evaluated(state, shifted).potential_energy).epsilon(1e-12));
}
