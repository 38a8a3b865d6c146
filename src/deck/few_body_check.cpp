#include "deck/few_body_check.hpp"

#include <fmt/format.h>

#include "engine/few_body_system.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double bytes_per_number = 20.0;  // in text form

/// Size of the two files that grow with the run.
double disk_bytes(const Deck& deck, const FewBodySystem& system) {
    const auto steps = static_cast<double>(total_steps(deck.stages()));
    double numbers = (1.0 + steps / static_cast<double>(deck.sample_every())) * (5.0 + 2.0 * system.dimensions);
    if (deck.trajectory) {
        const double vectors = deck.trajectory->accelerations ? 3.0 : 2.0;
        numbers += (1.0 + steps / static_cast<double>(deck.trajectory->every)) *
                   (2.0 + vectors * static_cast<double>(system.state.count()) * system.dimensions);
    }
    return bytes_per_number * numbers;
}

double energy_at_start(FewBodySystem& system) {
    return system.force_field->evaluate(system.state, Request::forces_and_energy).potential_energy +
           kinetic_energy(system.state);
}

}  // namespace

Document few_body_check_report(const Deck& deck) {
    FewBodySystem system = make_few_body_system(deck.few_bodies());
    const double energy = energy_at_start(system);
    const double disk = disk_bytes(deck, system);
    std::string text = fmt::format("{}: the deck is good. Nothing was run.\n", deck.path);
    text += fmt::format("  bodies    {}, in {} dimension{}\n", system.state.count(), system.dimensions,
                        system.dimensions == 1 ? "" : "s");
    text += fmt::format("  force     {}\n", system.force.plugin.name);
    text += fmt::format("  energy    {:.12g} at the start\n", energy);
    for (const Stage& stage : deck.stages()) {
        text += fmt::format("  stage     '{}': {} steps of {:.6g} = {:.6g}, {}{}\n", stage.name, stage.steps,
                            stage.time_step, static_cast<double>(stage.steps) * stage.time_step, stage.integrator.name,
                            stage.reverse ? ", backwards" : "");
    }
    text += fmt::format("  disk      about {:.3g} MB in {}\n", disk / 1e6, deck.directory.string());
    return {{{"deck", deck.path},
             {"bodies", system.state.count()},
             {"dimensions", system.dimensions},
             {"force", system.force.plugin.name},
             {"total_energy", energy},
             {"steps", total_steps(deck.stages())},
             {"disk_bytes", disk}},
            text};
}

}  // namespace ljmd
