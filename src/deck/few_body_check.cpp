#include "ljmd/deck/few_body_check.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "ljmd/deck/few_body.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double bytes_per_number = 20.0;  // in text form

/// Size of the two files that grow with the run.
double disk_bytes(const Deck& deck, const FewBodySystem& system) {
    const auto steps = static_cast<double>(deck.total_steps());
    double numbers = (1.0 + steps / static_cast<double>(deck.thermo_every)) * (5.0 + 2.0 * system.dimensions);
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

std::string few_body_check_report(const Deck& deck) {
    FewBodySystem system = make_few_body_system(deck);
    std::string text = fmt::format("{}: the deck is good. Nothing was run.\n", deck.path);
    text += fmt::format("  bodies    {}, in {} dimension{}\n", system.state.count(), system.dimensions,
                        system.dimensions == 1 ? "" : "s");
    text += fmt::format("  force     {}\n", system.force.plugin.name);
    text += fmt::format("  energy    {:.12g} at the start\n", energy_at_start(system));
    for (const Stage& stage : deck.stages) {
        text += fmt::format("  stage     '{}': {} steps of {:.6g} = {:.6g}, {}{}\n", stage.name, stage.steps,
                            stage.time_step, static_cast<double>(stage.steps) * stage.time_step,
                            stage.integrator.plugin.name, stage.reverse ? ", backwards" : "");
    }
    return text +
           fmt::format("  disk      about {:.3g} MB in {}\n", disk_bytes(deck, system) / 1e6, deck.directory.string());
}

std::string few_body_check_json(const Deck& deck) {
    FewBodySystem system = make_few_body_system(deck);
    const nlohmann::ordered_json json = {{"deck", deck.path},
                                         {"bodies", system.state.count()},
                                         {"dimensions", system.dimensions},
                                         {"force", system.force.plugin.name},
                                         {"total_energy", energy_at_start(system)},
                                         {"steps", deck.total_steps()},
                                         {"disk_bytes", disk_bytes(deck, system)}};
    // The path of a deck may not be UTF-8, but JSON must be.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ljmd
