// A planet on an ellipse about a star, in memory: the closest approaches and the period that its orbit has.
#include <ljmd/engine.hpp>

#include <cstdlib>
#include <iostream>

int main(int, char** arguments) {
    const ljmd::Index steps = arguments[1] != nullptr ? std::atol(arguments[1]) : 20000;
    ljmd::FewBodySpec spec{.force = ljmd::few_body_force("newtonian-gravity", {{"gravitational_constant", 1.0}}),
                           .bodies = {{.mass = 1.0, .position = {0.0, 0.0}, .velocity = {0.0, 0.0}},
                                      {.mass = 1e-6, .position = {1.0, 0.0}, .velocity = {0.0, 1.2}}}};
    spec.stages = {{.name = "orbits", .time_step = 0.005, .steps = steps, .sample = true}};
    spec.analyses = {ljmd::few_body_analysis("orbit", {{"body", 2}, {"about", 1}})};

    const ljmd::FewBodyResult result = ljmd::FewBodySimulation(spec).run();
    for (const auto& [analysis, findings] : result.findings) {
        for (const ljmd::Finding& found : findings) {
            std::cout << found.name << " = " << found.value << '\n';
        }
    }
    for (const ljmd::FewBodyHistory& total : result.histories) {
        std::cout << total.name << " changed by at most " << total.largest_deviation << '\n';
    }
}
