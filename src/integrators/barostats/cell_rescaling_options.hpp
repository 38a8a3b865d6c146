#pragma once

#include <string>

#include "integrators/barostat.hpp"

namespace ljmd {

/// The options of a barostat by stochastic cell rescaling.
struct CellRescalingOptions : BarostatOptions {
    double pressure = 0.0;          ///< p_0 [epsilon/sigma^3]
    double time = 2.0;              ///< tau_p [tau]
    double compressibility = 0.05;  ///< beta [sigma^3/epsilon]
    Index every = 10;               ///< steps between changes

    [[nodiscard]] double held_pressure() const override { return pressure; }
    [[nodiscard]] double volume_mobility() const override { return compressibility / time; }

  protected:
    /// What the keys mean, where the barostats differ.
    struct Meanings {
        std::string pressure;
        std::string time;
        std::string compressibility;
    };
    void describe_with(Description& description, const Meanings& meanings) {
        description.required_number("pressure", pressure)
            .dimension(Dimension::pressure)
            .unit("epsilon/sigma^3")
            .meaning(meanings.pressure);
        description.number("time", time).dimension(Dimension::time).unit("tau").above(0.0).meaning(meanings.time);
        description.number("compressibility", compressibility)
            .unit("sigma^3/epsilon")
            .above(0.0)
            .meaning(meanings.compressibility);
        description.integer("every", every).at_least(1).step_interval().meaning("steps between changes");
    }
};

}  // namespace ljmd
