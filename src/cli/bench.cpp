#include "cli/bench.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string>

#include "cli/example_decks.hpp"
#include "io/files/scratch_directory.hpp"
#include "io/tables/json_text.hpp"

namespace ljmd {

namespace {

/// Memory of this process [bytes] from the kernel: "VmRSS" now or "VmHWM" at its peak; 0 if unknown. (getrusage may
/// give the peak of the program that started this one.)
double memory(std::string_view field) {
    std::ifstream status("/proc/self/status");
    for (std::string name; status >> name;) {
        if (name.starts_with(field)) {
            double kibibytes = 0.0;
            return status >> kibibytes ? kibibytes * 1024.0 : 0.0;
        }
    }
    return 0.0;
}

/// Records the peak memory at the last step, because writing the results takes more.
struct MemoryAtEnd : RunListener {
    explicit MemoryAtEnd(Index last) : last_step(last) {}
    void step_done(Index step) override {
        if (step == last_step) {
            peak = memory("VmHWM");
        }
    }
    Index last_step;
    double peak = memory("VmHWM");
};

std::string list_policy(const NeighborSpec& neighbors) {
    if (!neighbors.keeps_list()) {
        return neighbors.method;
    }
    return neighbors.every ? fmt::format("every {} steps, pairs may be missed", *neighbors.every)
                           : "by displacement, no pair missed";
}

}  // namespace

std::string_view melt_deck() {
    return example_deck("melt-32k").text;
}

BenchResult bench(Deck deck, Start start, const Execution& execution) {
    const ScratchDirectory scratch;
    deck.directory = scratch.path();
    const double before = memory("VmRSS");
    const Index atoms = start.atoms;
    FluidSystem simulation = make_fluid(fluid_spec(deck, std::move(start)), execution, [](const std::string&) {});
    MemoryAtEnd memory(total_steps(deck.stages()));
    const RunResult result = run_plan(deck, simulation, memory);
    return {atoms,
            total_steps(deck.stages()),
            result.search.rebuilds,
            list_policy(deck.neighbors()),
            std::string(name(execution.precision())),
            std::string(name(execution.simd())),
            execution.threads(),
            result.seconds,
            (memory.peak - before) / static_cast<double>(atoms),
            result.first,
            result.last};
}

std::string bench_report(const BenchResult& result) {
    std::string text = fmt::format("{} atoms, {} steps, {} precision, {}, {} thread{}\n", result.atoms, result.steps,
                                   result.precision, result.simd, result.threads, result.threads == 1 ? "" : "s");
    text += fmt::format("lists {}: built {} times\n\n", result.lists, result.rebuilds);
    const double atom_steps = static_cast<double>(result.atoms) * static_cast<double>(result.steps);
    text += "  phase        seconds   ns/atom-step\n";
    const PhaseSeconds& s = result.seconds;
    const std::array<std::pair<const char*, double>, 7> phases{{{"force", s.force},
                                                                {"list", s.list},
                                                                {"sort", s.sort},
                                                                {"integrate", s.integrate},
                                                                {"observe", s.observe},
                                                                {"write", s.write},
                                                                {"all", s.sum()}}};
    for (const auto& [phase, seconds] : phases) {
        text += fmt::format("  {:<9} {:>10.4f} {:>14.2f}\n", phase, seconds, 1e9 * seconds / atom_steps);
    }
    text += fmt::format("\n  {:.2f} million atom-steps per second, {:.0f} bytes per atom\n",
                        1e-6 * result.atom_steps_per_second(), result.bytes_per_atom);
    text += fmt::format("  E/N {:.10f} at the start, {:.10f} at the end\n", result.first.total_energy,
                        result.last.total_energy);
    return text;
}

std::string bench_json(const BenchResult& result) {
    const Data json = {{"atoms", result.atoms},
                       {"steps", result.steps},
                       {"threads", result.threads},
                       {"precision", result.precision},
                       {"simd", result.simd},
                       {"lists", result.lists},
                       {"list_rebuilds", result.rebuilds},
                       {"atom_steps_per_second", result.atom_steps_per_second()},
                       {"seconds", result.seconds.sum()},
                       {"seconds_per_phase", phases_data(result.seconds)},
                       {"bytes_per_atom", result.bytes_per_atom},
                       {"potential_energy_initial", result.first.potential_energy},
                       {"total_energy_initial", result.first.total_energy},
                       {"potential_energy_final", result.last.potential_energy},
                       {"total_energy_final", result.last.total_energy},
                       {"temperature_final", result.last.temperature}};
    return to_json(json) + "\n";
}

}  // namespace ljmd
