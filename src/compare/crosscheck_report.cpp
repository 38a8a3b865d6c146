#include "compare/crosscheck_report.hpp"

#include <fmt/format.h>

#include "core/text_table.hpp"
#include "io/tables/data_table_csv.hpp"
#include "io/tables/json_text.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"
#include "run/run_report.hpp"

namespace ljmd {

namespace {

using Align = TextTable::Align;

std::string path_line(const Crosscheck& found) {
    return fmt::format("{}, {}, {} precision, {} thread{}", found.search, found.simd, found.precision, found.threads,
                       found.threads == 1 ? "" : "s");
}

std::string average_lines(const EnsembleComparison& ensemble, const std::string& peer) {
    constexpr std::size_t width = 10;
    TextTable table({{"average, no tail", Align::left, 20},
                     {"ljmd", Align::right, width},
                     {"error", Align::right, width},
                     {peer, Align::right, width},
                     {"error", Align::right, width},
                     {"sigmas", Align::right, 7}});
    for (const auto& row : ensemble.rows) {
        const auto [ours, our_error] = mean_and_error(row.ours.mean, row.ours.standard_error);
        const auto [theirs, their_error] = mean_and_error(row.theirs.mean, row.theirs.standard_error);
        table.add({row.name, ours, our_error, theirs, their_error, fmt::format("{:.2f}", row.sigmas())});
    }
    return table.text() +
           "pressures are (2 K + W)/(3 V), as LAMMPS prints them: a convention; rho T + W/(3 V), as a run of ljmd has "
           "them, is larger by T/V\n";
}

Data trajectory_data(const TrajectoryComparison& trajectory) {
    Data pairings = Data::list();
    for (const auto& [ours, theirs, same_order] : trajectory.pairings) {
        pairings.push_back({{"ours", ours}, {"theirs", theirs}});
    }
    Data rows = Data::list();
    for (const auto& row : trajectory.rows) {
        rows.push_back({{"step", row.step},
                        {"time", row.time},
                        {"distances", row.distances},
                        {"potential_energy_difference", row.potential_difference},
                        {"kinetic_energy_difference", row.kinetic_difference}});
    }
    return {{"time_step", trajectory.time_step},
            {"pairings", pairings},
            {"rows", rows},
            {"divergence_rate", trajectory.divergence_rate()}};
}

Data estimate_data(const Estimate& estimate) {
    return {{"mean", estimate.mean}, {"standard_error", estimate.standard_error}};
}

DataTable trajectory_table(const TrajectoryComparison& trajectory, const std::string& name) {
    DataTable table{name + "-trajectory", {"step", "time"}, {}};
    for (const auto& pairing : trajectory.pairings) {
        table.columns.push_back(fmt::format("{} - {}", pairing.ours, pairing.theirs));
    }
    table.columns.insert(table.columns.end(), {"potential_energy_difference", "kinetic_energy_difference"});
    for (const auto& row : trajectory.rows) {
        table.rows.push_back({static_cast<double>(row.step), row.time});
        table.rows.back().insert(table.rows.back().end(), row.distances.begin(), row.distances.end());
        table.rows.back().insert(table.rows.back().end(), {row.potential_difference, row.kinetic_difference});
    }
    return table;
}

DataTable rdf_table(const EnsembleComparison& ensemble, const std::string& name) {
    DataTable table{name + "-rdf", {"r", "g_ljmd", "g_ljmd_standard_error", "g_peer", "g_peer_standard_error"}, {}};
    for (const auto& bin : ensemble.rdf) {
        table.rows.push_back({bin.r, bin.ours, bin.our_error, bin.theirs, bin.their_error});
    }
    return table;
}

}  // namespace

std::string check_lines(const std::vector<Check>& checks) {
    TextTable table({{"check", Align::left}, {"found", Align::right, 12}, {"allowed", Align::right, 10}, {""}});
    for (const Check& check : checks) {
        table.add({check.name, fmt::format("{:.2e}", check.value), fmt::format("{:.1e}", check.tolerance),
                   check.passed() ? "" : "FAILED"});
    }
    return table.text();
}

Data checks_data(const std::vector<Check>& checks) {
    Data json = Data::list();
    for (const Check& check : checks) {
        json.push_back(
            {{"name", check.name}, {"value", check.value}, {"tolerance", check.tolerance}, {"passed", check.passed()}});
    }
    return json;
}

std::string crosscheck_table(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options) {
    std::string text =
        fmt::format("{}\nagainst {}{}\n{} atoms, after {} steps of the deck\nljmd: {}\n\n", title_line(deck),
                    found.peer, found.fast_peer == found.peer ? "" : ", long runs " + found.fast_peer, found.atoms,
                    found.steps_before, path_line(found));
    text += check_lines(found.checks) + '\n';
    if (const auto rate = found.trajectory.divergence_rate()) {
        text += fmt::format("trajectories part like exp({:.2f} t/tau)\n\n", *rate);
    }
    if (found.ensemble) {
        text += fmt::format("{} steps of {}, {} configurations for g(r)\n", found.steps_of_averages, found.integrator,
                            found.ensemble->frames) +
                average_lines(*found.ensemble, options.with) + '\n';
    }
    if (found.speed) {
        text += fmt::format("speed: ljmd {:.3g}, {} {:.3g} million atom-steps/s, ratio {:.2f}\n\n",
                            1e-6 * found.speed->ours, found.fast_peer, 1e-6 * found.speed->theirs,
                            found.speed->ours / found.speed->theirs);
    }
    if (found.checks.empty()) {
        return text + "nothing was judged\n";
    }
    return text + (found.passed() ? fmt::format("all {} checks passed\n", found.checks.size())
                                  : fmt::format("{} of {} checks FAILED\n", found.failures(), found.checks.size()));
}

std::string crosscheck_json(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options) {
    Data json = {
        {"deck", deck.path},
        {"with", options.with},
        {"peer", found.peer},
        {"peer_of_long_runs", found.fast_peer},
        {"atoms", found.atoms},
        {"steps_before", found.steps_before},
        {"path",
         {{"search", found.search}, {"simd", found.simd}, {"precision", found.precision}, {"threads", found.threads}}},
        {"pressure_convention", "(2 K + W)/(3 V)"},
        {"checks", checks_data(found.checks)},
        {"passed", found.passed()}};
    if (!found.trajectory.rows.empty()) {
        json["trajectory"] = trajectory_data(found.trajectory);
    }
    if (found.ensemble) {
        Data averages = Data::object();
        for (const auto& row : found.ensemble->rows) {
            averages[row.name] = {
                {"ljmd", estimate_data(row.ours)}, {"peer", estimate_data(row.theirs)}, {"sigmas", row.sigmas()}};
        }
        json["averages"] = {{"integrator", found.integrator},
                            {"steps", found.steps_of_averages},
                            {"rdf_configurations", found.ensemble->frames},
                            {"observables", averages}};
    }
    if (found.speed) {
        json["atom_steps_per_second"] = {{"ljmd", found.speed->ours}, {"peer", found.speed->theirs}};
    }
    return to_json(json);
}

void write_crosscheck(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options,
                      const std::filesystem::path& directory, bool force) {
    const Replacing allowed{.force = force, .instead = another_directory};
    make_directory(directory);
    const std::string name = "compare-" + options.with;
    const auto write = [&](const DataTable& table) {
        write_output(directory / (table.name + ".csv"), allowed, to_csv(table));
    };
    if (!found.trajectory.rows.empty()) {
        write(trajectory_table(found.trajectory, name));
    }
    if (found.ensemble && !found.ensemble->rdf.empty()) {
        write(rdf_table(*found.ensemble, name));
    }
    write_output(directory / (name + ".json"), allowed, crosscheck_json(found, deck, options) + "\n");
}

}  // namespace ljmd
