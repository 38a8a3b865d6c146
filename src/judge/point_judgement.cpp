#include "judge/point_judgement.hpp"

#include <algorithm>
#include <cmath>

#include "compare/fluid.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double wider = 10.0;  ///< than the tolerances of LAMMPS

/// Forces below this are rounding errors of a vanishing sum.
constexpr double vanishing_force = 1e-9;

}  // namespace

double ExpectedPoint::temperature() const {
    const Index freedom = degrees_of_freedom(atoms);
    return freedom > 0 ? 2.0 * kinetic_energy / static_cast<double>(freedom) : 0.0;
}

double ExpectedPoint::pressure() const {
    return (2.0 * kinetic_energy + sums.virial) / (3.0 * volume) + tail_pressure;
}

double ExpectedPoint::squared_frequency() const {
    double squares = 0.0;
    for (const Vec3& f : sums.forces) {
        squares += f.squaredNorm();
    }
    return kinetic_energy > 0.0 ? squares / (2.0 * kinetic_energy) : 0.0;
}

ExpectedPoint expected_point(const Fluid& fluid, const PeerPoint& ours) {
    const auto atoms = static_cast<Index>(fluid.masses.size());
    return {.sums = {ours.totals.potential_energy, ours.totals.virial, ours.forces},
            .kinetic_energy = ours.totals.kinetic_energy,
            .tail_energy = static_cast<double>(atoms) * ours.tail_energy.value_or(0.0),
            .tail_pressure = ours.tail_pressure.value_or(0.0),
            .volume = fluid.edges.prod(),
            .atoms = atoms};
}

Agreement engine_agreement(const Situation& situation) {
    Agreement agreement = lammps_agreement(situation);
    for (double* limit : {&agreement.energy, &agreement.largest_force, &agreement.rms_force, &agreement.pressure,
                          &agreement.kinetic_energy}) {
        *limit *= wider;
    }
    for (auto* limits : {&agreement.positions, &agreement.positions_in_the_same_order}) {
        for (Agreement::Limit& limit : *limits) {
            limit.distance *= wider;
        }
    }
    return agreement;
}

std::vector<Check> check_point(const ExpectedPoint& expected, const PointAnswer& answer, const Agreement& agreement) {
    std::vector<Check> checks;
    const auto add = [&](const char* name, std::optional<double> theirs, double ours, double size, double tolerance) {
        if (theirs) {
            const double off = std::abs(*theirs - ours);
            checks.push_back({name, size > 0.0 ? off / size : off, tolerance});
        }
    };
    add("potential energy", answer.potential_energy, expected.potential_energy(),
        std::abs(expected.sums.potential_energy), agreement.energy);
    if (!answer.forces.empty()) {
        double largest = 0.0;
        double squares = 0.0;
        double ours = 0.0;
        for (std::size_t i = 0; i < answer.forces.size(); ++i) {
            const double difference = (expected.sums.forces[i] - answer.forces[i]).norm();
            largest = larger_or_nan(largest, difference);
            squares += difference * difference;
            ours += expected.sums.forces[i].squaredNorm();
        }
        const auto count = static_cast<double>(answer.forces.size());
        const double rms = std::sqrt(ours / count);
        const double unit = rms > vanishing_force ? rms : 1.0;
        checks.push_back({"largest force difference", largest / unit, agreement.largest_force});
        checks.push_back({"rms force difference", std::sqrt(squares / count) / unit, agreement.rms_force});
    }
    const double terms = 2.0 * expected.kinetic_energy + std::abs(expected.sums.virial);
    add("virial", answer.virial, expected.sums.virial, terms, agreement.pressure);
    add("kinetic energy", answer.kinetic_energy, expected.kinetic_energy, expected.kinetic_energy, agreement.energy);
    add("temperature", answer.temperature, expected.temperature(), expected.temperature(), agreement.energy);
    add("pressure", answer.pressure, expected.pressure(), terms / (3.0 * expected.volume), agreement.pressure);
    return checks;
}

}  // namespace ljmd
