// What the user of the library can do wrong ends in an Error, never in a ContractViolation.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/analysis.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("whatever a specification says, the failure is an Error with a message") {
    const auto fails = [](FluidSpec spec, const std::function<void(FluidSpec&)>& spoil) {
        spoil(spec);
        std::string message;
        try {
            Simulation(spec).run();
        } catch (const Error& error) {
            message = error.what();
        }
        CHECK_FALSE(message.empty());
    };
    const FluidSpec good = small_spec();
    const std::vector<Vec3> two{Vec3::Zero(), Vec3::Ones()};
    fails(good, [&](FluidSpec& s) { s.start = Configuration{.edges = Vec3(1e17, 1.0, 1.0), .positions = two}; });
    fails(good, [&](FluidSpec& s) { s.start = Configuration{.edges = Vec3::Constant(1e-310), .positions = two}; });
    fails(good, [&](FluidSpec& s) {
        s.start = Configuration{.edges = Vec3::Constant(5.0), .positions = {Vec3::Zero(), Vec3::Constant(1e300)}};
    });
    fails(good, [&](FluidSpec& s) { s.start = Configuration{.edges = Vec3::Constant(5.0), .positions = {}}; });
    fails(good, [](FluidSpec& s) { s.density = 1e-320; });
    fails(good, [](FluidSpec& s) { s.density = 1e300; });
    fails(good, [](FluidSpec& s) { s.start = LatticeStart{.cells = 2000}; });
    fails(good, [](FluidSpec& s) { s.start = LatticeStart{.cells = std::numeric_limits<Index>::max()}; });
    fails(good, [](FluidSpec& s) { s.start = RandomStart{std::numeric_limits<Index>::min()}; });
    fails(good, [](FluidSpec& s) { s.potential = PairPotential::lennard_jones("cut", {std::nan(""), 0.0}); });
    fails(good, [](FluidSpec& s) {
        const auto endless = [](const PairDistance<double>& d) { return PairTerm<double>{d.inverse_r, d.inverse_r}; };
        s.potential = PairPotential::custom("endless", endless, "cut", {2.0, 0.0});
        s.tail = true;  // the integral of u r^2 diverges
    });
    fails(good, [](FluidSpec& s) {
        const auto broken = [](const PairDistance<double>&) { return PairTerm<double>{0.0, std::nan("")}; };
        s.potential = PairPotential::custom("broken", broken, "cut", {2.0, 0.0});
    });
    for (const double tiny : {1e-300, 1e-9, 0.1}) {
        fails(good, [=](FluidSpec& s) { s.analyses = {analysis("structure_factor", {{"k_max", tiny}})}; });
    }
    fails(good, [](FluidSpec& s) { s.analyses = {analysis("msd", {{"max_time", 1e-300}})}; });
    fails(good, [](FluidSpec& s) { s.analyses = {analysis("rdf", {{"radius", 1e300}})}; });
    FluidSpec none = good;
    none.stages.clear();
    CHECK_THROWS_AS(sampled_run(none.stages, 1, 108, Box(Vec3::Constant(5.0))), InputError);
    CHECK_THROWS_AS(first_sampled(none.stages), InputError);
    none.start = LatticeStart{.cells = -1};
    CHECK_THROWS_AS(atoms_of(none), InputError);
    CHECK_THROWS_AS(box_of(none), InputError);
}

namespace {

/// Values at the ends of what a key allows, and far beyond what is usual.
std::vector<PlainValue> extremes(const Key& key) {
    if (key.kind == Kind::number) {
        return {std::max(key.low, 1e-300), 1e-9, 1e9, std::min(key.high, 1e300)};
    }
    if (key.kind == Kind::integer) {
        return {static_cast<std::int64_t>(std::max(key.low, -1e9)), std::int64_t{1}, std::int64_t{1000}};
    }
    std::vector<PlainValue> all(key.choices.begin(), key.choices.end());
    return all;
}

/// Run with each option of each plug-in at its extremes. Whatever comes of it is a result or an Error.
template <class Plugin, class Choose>
void try_extremes(const std::vector<Plugin>& plugins, const Choose& choose_in) {
    for (const Plugin& plugin : plugins) {
        const std::vector<Key> keys = keys_of(plugin);
        Settings needed;
        for (const Key& key : keys) {
            if (key.required) {
                needed.emplace_back(key.name, 1.0);
            }
        }
        for (const Key& key : keys) {
            for (const PlainValue& value : extremes(key)) {
                Settings settings{{key.name, value}};
                std::ranges::copy_if(needed, std::back_inserter(settings),
                                     [&key](const auto& setting) { return setting.first != key.name; });
                INFO(plugin.name << " " << settings_in_words(settings));
                FluidSpec spec = small_spec();
                try {
                    choose_in(spec, plugin.name, settings);
                    Simulation(spec).run();
                } catch (const Error& error) {
                    CHECK_FALSE(std::string(error.what()).empty());
                }
            }
        }
    }
}

}  // namespace

TEST_CASE("no option of a plug-in, however extreme, is taken for a bug of the library") {
    try_extremes(all_integrators(), [](FluidSpec& spec, const std::string& name, const Settings& settings) {
        spec.stages[1].integrator = integrator(name, settings);
    });
    try_extremes(all_thermostats(), [](FluidSpec& spec, const std::string& name, const Settings& settings) {
        spec.stages[1].thermostat = thermostat(name, settings);
    });
    try_extremes(all_barostats(), [](FluidSpec& spec, const std::string& name, const Settings& settings) {
        spec.stages[1].thermostat = thermostat("stochastic-rescaling");
        spec.stages[1].barostat = barostat(name, settings);
    });
    try_extremes(all_analyses(), [](FluidSpec& spec, const std::string& name, const Settings& settings) {
        spec.analyses = {analysis(name, settings)};
    });
    for (const double number : {1e-320, 1e-300, 1e-9, 1e9, 1e300}) {
        CAPTURE(number);
        for (const auto& set : std::vector<std::function<void(FluidSpec&)>>{
                 [=](FluidSpec& s) { s.stages[1].time_step = number; }, [=](FluidSpec& s) { s.temperature = number; },
                 [=](FluidSpec& s) { s.stages[0].temperature = number; }, [=](FluidSpec& s) { s.density = number; },
                 [=](FluidSpec& s) {
                     s.potential = PairPotential::lennard_jones("shifted", {number, 0.0});
                 },
                 [=](FluidSpec& s) { s.neighbors.skin = number; }}) {
            FluidSpec spec = small_spec();
            set(spec);
            try {
                Simulation(spec).run();
            } catch (const Error& error) {
                CHECK_FALSE(std::string(error.what()).empty());
            }
        }
    }
}
