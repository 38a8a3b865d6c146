#include "ljmd/app/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <new>
#include <nlohmann/json.hpp>

#include "ljmd/app/deck_sense.hpp"
#include "ljmd/app/forecast.hpp"
#include "ljmd/app/progress.hpp"
#include "ljmd/app/results.hpp"
#include "ljmd/app/run.hpp"
#include "ljmd/app/run_directory.hpp"
#include "ljmd/app/streams.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/registry.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/integrators/thermostat.hpp"
#include "ljmd/neighbors/pair_search.hpp"

namespace ljmd {

namespace {

void print_warnings(const Diagnostics& diagnostics) {
    for (const Diagnostic& entry : diagnostics.entries()) {
        if (entry.severity == Severity::warning) {
            talk(format(entry) + '\n');
        }
    }
}

/// A deck that is right in every respect, with the start it describes.
struct CheckedDeck {
    Deck deck;
    Start start;
};

CheckedDeck load_checked(const DeckOptions& options) {
    Diagnostics diagnostics;
    auto deck = load_deck(options.deck, options.settings, options.force, diagnostics);
    diagnostics.throw_if_errors();
    Start start = find_start(*deck);
    if (start.configuration) {  // only now is the box known
        check_box(deck->root, start.box, diagnostics);
        diagnostics.throw_if_errors();
    }
    if (!options.quiet) {
        print_warnings(diagnostics);
    }
    return {std::move(*deck), std::move(start)};
}

std::string check_json(const CheckedDeck& checked, const Forecast& forecast) {
    const Vec3& edges = checked.start.box.edges();
    const nlohmann::ordered_json json = {{"deck", checked.deck.path},
                                         {"atoms", checked.start.atoms},
                                         {"box_edges", {edges[0], edges[1], edges[2]}},
                                         {"cutoff", checked.deck.potential().number("cutoff")},
                                         {"largest_cutoff", 0.5 * checked.start.box.shortest_edge()},
                                         {"steps", checked.deck.total_steps()},
                                         {"memory_bytes", forecast.memory_bytes},
                                         {"disk_bytes", forecast.disk_bytes},
                                         {"seconds", forecast.seconds}};
    // The path of a deck need not be UTF-8, as JSON must.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

void run_command(const DeckOptions& options, const std::string& out) {
    CheckedDeck checked = load_checked(options);
    if (!out.empty()) {
        checked.deck.directory = out;
    }
    // The start is made before anything is touched: what refuses it must not cost an earlier run.
    check_directory(checked.deck, options.force);
    Progress progress(checked.start.atoms, checked.deck.total_steps(), options.quiet);
    Simulation simulation = make_simulation(checked.deck, std::move(checked.start),
                                            [&](const std::string& text) { progress.warning(text); });
    prepare_directory(checked.deck.directory);
    const RunResult result = run_deck(checked.deck, simulation, progress);
    if (options.json) {
        print_result(results_json(checked.deck, result) + "\n");
    } else {
        print_result(results_table(checked.deck, result));
    }
}

void check_command(const DeckOptions& options) {
    const CheckedDeck checked = load_checked(options);
    const Forecast cost = forecast(checked.deck, checked.start);
    print_result(options.json ? check_json(checked, cost) : check_report(checked.deck, checked.start, cost));
}

void info_command(bool keys) {
    if (keys) {
        print_result(deck_reference_page());
        return;
    }
    const BuildInfo& build = build_info();
    std::string text = fmt::format("ljmd {} (commit {})\n", build.version, build.commit);
    text += fmt::format("compiler      {} {}, {}\nflags         {}\n", build.compiler, build.compiler_version,
                        build.build_type, build.flags);
    text += "simd          none (portable scalar code), double precision, one thread\n";
    text += fmt::format("potentials    {}\n", fmt::join(PairPotential::formula_names(), ", "));
    text += fmt::format("truncations   {}\n", fmt::join(PairPotential::truncation_names(), ", "));
    text += fmt::format("pair search   {}\n", fmt::join(pair_search_names(), ", "));
    text += fmt::format("integrators   {}\n", fmt::join(plugin_names(all_integrators()), ", "));
    text += fmt::format("thermostats   {}\n", fmt::join(plugin_names(all_thermostats()), ", "));
    text += fmt::format("analyses      {}\n", fmt::join(plugin_names(all_analyses()), ", "));
    text += "trajectories  h5md, xyz\n";
    print_result(text);
}

int report_current_exception() {
    const auto say = [](const char* text) {
        const std::string message(text);
        // Diagnostics arrive with their own "error:" in front of each line that needs it.
        talk(fmt::format("{}{}\n", message.starts_with("error:") ? "" : "error: ", message));
    };
    try {
        throw;
    } catch (const InputError& e) {
        say(e.what());
        return 2;
    } catch (const DataError& e) {
        say(e.what());
        return 3;
    } catch (const FileError& e) {
        say(e.what());
        return 4;
    } catch (const PhysicsError& e) {
        say(e.what());
        return 5;
    } catch (const std::bad_alloc&) {
        say("out of memory; `ljmd check` tells how much a deck needs");
        return 7;
    } catch (const std::exception& e) {
        talk(fmt::format("internal error: {}\nThis is a bug in ljmd; please report it with the deck.\n", e.what()));
        return 1;
    }
}

}  // namespace ljmd
