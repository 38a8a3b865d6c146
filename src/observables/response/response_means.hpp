#pragma once

#include <Eigen/Core>

#include "ljmd/core/types.hpp"

namespace ljmd::response {

/// Columns of the series whose means determine response functions. A prime means: minus its value in the first sample,
/// so that no digits are lost in variances. u is the energy and v the volume per atom, P the pressure without its
/// kinetic part, T the temperature of the motion about the centre of mass.
enum Column : Index {
    temperature,          // T
    inverse_temperature,  // 1/T
    energy,               // u'
    pressure,             // P'
    volume,               // v'
    stiffness,            // P + V times its derivative at fixed scaled positions, with the sign changed: X/(9 V)
    energy_energy,        // u' u'
    energy_pressure,      // u' P'
    pressure_pressure,    // P' P'
    volume_volume,        // v' v'
    energy_volume,        // u' v'
    inverse_pressure,     // P'/T
    inverse_pressure_2,   // P' P'/T
    columns
};

/// What the formulas of an ensemble use. Covariances are multiplied by `share`, which is 1: the derivative with respect
/// to it tells how much a value suffers from variances that a short run underestimates.
template <class Real>
struct Means {
    Eigen::Matrix<Real, columns, 1> mean;
    Real share;
    double first_pressure;  ///< P of the first sample
    double first_volume;    ///< v of the first sample
    double atoms;
    double held_pressure;  ///< only where a barostat holds one

    [[nodiscard]] Real pressure() const { return mean[response::pressure] + first_pressure; }
    [[nodiscard]] Real density() const { return Real(1.0) / Real(mean[response::volume] + first_volume); }
    /// <a b> - <a> <b>
    [[nodiscard]] Real covariance(Column product, Column a, Column b) const {
        return share * Real(mean[product] - mean[a] * mean[b]);
    }
};

/// Three response functions from which all others follow.
template <class Real>
struct Basis {
    Real heat_capacity;   ///< c_v, with 3/2 of the motion [k_B]
    Real pressure_slope;  ///< gamma_V = (dp/dT)_V [k_B/sigma^3]
    Real bulk_modulus;    ///< K_T = 1/kappa_T = -V (dp/dV)_T [epsilon/sigma^3]
};

}  // namespace ljmd::response
