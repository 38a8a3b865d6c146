#include "report/pages/fluid_page.hpp"

#include <fmt/format.h>

#include <limits>

#include "analyze/thermo_report.hpp"
#include "deck/fluid.hpp"
#include "engine/result_doubts.hpp"
#include "io/files/input_file.hpp"
#include "io/formats/configuration_reader.hpp"
#include "io/tables/data_table_csv.hpp"
#include "report/atom_frames.hpp"
#include "report/lenient_data.hpp"
#include "report/run_charts.hpp"
#include "report/run_quantities.hpp"
#include "report/run_verdicts.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// The last step of the history; 0 if there is none.
double last_step(const fs::path& directory) {
    try {
        const std::vector<double> steps = column(read_growing_csv(directory / "thermo.csv"), "step");
        return steps.empty() ? 0.0 : steps.back();
    } catch (const DataError&) {
        return 0.0;  // add_history() warns
    }
}

/// A single configuration, for a run without frames.
Data configuration_atoms(const fs::path& path, const std::string& words) {
    AtomFrames frames(1);
    frames.add({.configuration = read_configuration(path, std::nullopt)});
    return frames.data(words);
}

void add_atoms(PageContent& page, const RunFacts& facts) {
    const Deck* deck = facts.deck();
    if (deck != nullptr && deck->trajectory) {
        const fs::path path = facts.directory / fmt::format("trajectory.{}", deck->trajectory->format);
        const double expected = last_step(facts.directory) / static_cast<double>(deck->trajectory->every) + 1.0;
        page.atoms = trajectory_atoms(path, deck->units(), static_cast<Index>(expected), page.warnings);
    }
    const auto show_if_nothing_else = [&](const char* name, const char* words) {
        if (page.atoms.is_null() && input_is_there(facts.directory / name)) {
            add_if_readable(page.warnings, [&] { page.atoms = configuration_atoms(facts.directory / name, words); });
        }
    };
    show_if_nothing_else("final.xyz", "It is the last configuration; the run has no trajectory.");
    show_if_nothing_else("failed.xyz", "It is the configuration at which the run stopped.");
}

void add_correlation_times(PageContent& page, const ThermoReport& report) {
    PageTable table{.name = "equilibration", .title = "Equilibration and correlation times"};
    std::vector<std::string> names;
    std::vector<double> times;
    std::vector<double> independent;
    std::vector<double> starts;
    std::vector<std::string> states;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const ThermoReport::Column& column : report.columns) {
        const auto step = equilibrated_at_step(report, column);
        names.push_back(column.average.name);
        states.push_back(state_of(column));
        starts.push_back(step ? static_cast<double>(*step) : unknown);
        times.push_back(correlation_time(report, column).value_or(unknown));
        independent.push_back(column.average.estimate ? column.average.estimate->independent_samples : unknown);
    }
    table.add({"observable"}, names);
    table.add({"equilibrium"}, states);
    table.add({"equilibrated_at_step", "in equilibrium from step"}, starts);
    table.add({"correlation_time", "correlation time", "tau"}, times);
    table.add({"independent_samples", "independent samples"}, independent);
    page.tables.push_back(std::move(table));
}

/// Whether the run measures a crystal, which is then what it is to be.
bool measures_crystal(const RunFacts& facts) {
    return value_in(facts.results, {"observables", "bragg_peak"}) != nullptr;
}

/// Verdict on the crystal that was there when sampling began, in place of that on a fluid which has not melted.
Verdict crystal_verdict(double order, bool there) {
    return {"crystal", there ? "good" : "doubt",
            there ? fmt::format("The crystal was there when sampling began: translational order {:.2f}.", order)
                  : fmt::format("The crystal was gone when sampling began: translational order {:.2f}.", order)};
}

}  // namespace

PageContent fluid_page(const RunFacts& facts) {
    PageContent page = page_of(facts);
    const bool crystal = measures_crystal(facts);
    const auto order = number_in(facts.results, {"translational_order_at_sampling"});
    const auto atoms = number_in(facts.results, {"system", "atoms"});
    const bool crystal_left =
        order && atoms && *atoms >= 1.0 && *order > largest_molten_order(static_cast<Index>(*atoms));
    std::optional<ThermoReport> thermo;
    if (facts.run && input_is_there(facts.directory / "thermo.csv")) {
        try {
            thermo = thermo_report(*facts.run);
            page.verdicts.push_back(equilibrium_verdict(*thermo, crystal_left && !crystal ? order : std::nullopt));
        } catch (const Error& error) {
            page.verdicts.push_back(
                {"equilibrium", "unknown", fmt::format("Equilibrium cannot be judged: {}.", error.what())});
        }
    }
    if (crystal && order) {
        page.verdicts.push_back(crystal_verdict(*order, crystal_left));
    }
    if (!facts.results.is_null()) {
        for (Verdict& verdict : result_verdicts(facts)) {
            page.verdicts.push_back(std::move(verdict));
        }
    }
    page.quantities = run_quantities(facts, thermo);
    if (facts.run && crystal) {
        page.verdicts.push_back(reference_verdict({}, "they are of fluids, and this run measures a crystal"));
    } else if (facts.run) {
        add_if_readable(page.warnings, [&] {
            const std::string equation = add_references(
                page.quantities, facts.run->deck, number_in(facts.results, {"system", "density"}), facts.directory);
            page.verdicts.push_back(reference_verdict(page.quantities, equation));
        });
    }
    if (input_is_there(facts.directory / "thermo.csv")) {
        add_if_readable(page.warnings, [&] { add_history(page, facts); });
    }
    add_analyses(page, facts);
    if (input_is_there(facts.directory / "thermo.csv")) {
        add_if_readable(page.warnings, [&] { add_blocking_curves(page, facts); });
    }
    if (thermo) {
        add_correlation_times(page, *thermo);
    }
    add_phases(page, facts);
    add_atoms(page, facts);
    return page;
}

}  // namespace ljmd
