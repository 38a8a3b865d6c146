#include "ljmd/study/replicas.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/deck/fluid.hpp"
#include "ljmd/input/deck_setting.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/io/files/replacement_file.hpp"
#include "ljmd/io/tables/data_table_csv.hpp"
#include "ljmd/io/tables/json_file.hpp"
#include "ljmd/observables/statistics/known_quantities.hpp"
#include "ljmd/run/results.hpp"
#include "ljmd/run/run_report.hpp"
#include "ljmd/study/replica_merge.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, 2> merged_tables{"rdf", "sk"};  // those whose rows are averages at fixed places
constexpr const char* seed_key = "system.seed";

/// A stage name as a part of a key.
std::string key_part(const std::string& name) {
    const bool bare = !name.empty() && std::ranges::all_of(name, [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-';
    });
    return bare ? name : fmt::format("\"{}\"", name);
}

double number_or(const Data* value, double otherwise) {
    return value != nullptr && !value->is_null() ? value->number() : otherwise;
}

std::uint64_t seed_of(const Deck& deck) {
    return static_cast<std::uint64_t>(deck.system().seed);
}

/// An observable of one run, from its results.json.
struct Found {
    std::string name;
    std::string unit;
    ReplicaMean mean;
    double independent;
    std::string remark;
};

struct FoundRun {
    std::vector<Found> observables;
    std::vector<std::string> doubts;
};

FoundRun found_run(const ChildRun& run) {
    return read_json(run.directory / "results.json", "the results of a run", [](const Data& results) {
        FoundRun found;
        for (const auto& [name, entry] : results.at("observables").members()) {
            if (entry.at("mean").is_null()) {
                continue;
            }
            const Data* remark = entry.find("remark");
            found.observables.push_back({name,
                                         entry.at("unit").text(),
                                         {entry.at("mean").number(), number_or(entry.find("standard_error"), no_number),
                                          static_cast<double>(integer_of(entry.at("samples"), "samples", 1, max_steps)),
                                          entry.at("error_is_converged").flag()},
                                         number_or(entry.find("independent_samples"), no_number),
                                         remark != nullptr ? remark->text() : ""});
        }
        for (const Data& doubt : results.at("doubts").items()) {
            found.doubts.push_back(doubt.text());
        }
        return found;
    });
}

/// An observable of all runs.
struct Merged {
    ObservableAverage average;
    MergedMean mean;
};

/// Nothing if a run lacks it.
std::optional<Merged> merged(const Found& first, const std::vector<FoundRun>& runs) {
    std::vector<ReplicaMean> means;
    means.reserve(runs.size());
    double independent = 0.0;
    double samples = 0.0;
    for (const FoundRun& run : runs) {
        const auto found = std::ranges::find(run.observables, first.name, &Found::name);
        if (found == run.observables.end()) {
            return std::nullopt;
        }
        means.push_back(found->mean);
        independent += found->independent;
        samples += found->mean.samples;
    }
    const MergedMean mean = merged_mean(means);
    // A larger error counts fewer samples as independent.
    const double larger = mean.standard_error / mean.within;
    const double counted = std::isfinite(larger) && larger > 0.0 ? independent / (larger * larger) : independent;
    const bool converged = runs.size() > 1 || means.front().converged;
    ObservableAverage average{first.name, symbol_of(first.name), first.unit,
                              Estimate{mean.mean, mean.standard_error, std::clamp(counted, 1.0, samples),
                                       static_cast<Index>(samples), converged}};
    if (!mean.agree) {
        average.remark = "the replicas differ by more than their errors let expect: its error is from their scatter";
    }
    return Merged{average, mean};
}

/// Doubts of the runs, each once, with the number of runs that have it.
std::vector<std::string> doubts_of(const std::vector<FoundRun>& runs, const std::vector<ChildRun>& children) {
    std::vector<std::string> doubts;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        for (const std::string& doubt : runs[k].doubts) {
            doubts.push_back(fmt::format("{}: {}", children[k].name, doubt));
        }
    }
    return doubts;
}

}  // namespace

std::uint64_t replica_seed(std::uint64_t seed, Index number) {
    const auto bytes = static_cast<std::uint64_t>(number);
    return XXH3_64bits_withSeed(&bytes, sizeof bytes, seed) >> 11U;
}

SweepPlan replica_plan(const Deck& deck, const std::vector<std::string>& settings, Index replicas) {
    SweepPlan plan{.deck_file = deck.path, .deck = deck.source, .settings = {}, .points = {{seed_key}, {}}};
    plan.replicas = replicas;
    const Stage& last = deck.stages.back();
    std::vector<std::string> errors;
    errors.reserve(last.until.size());
    for (const WantedError& wanted : last.until) {
        plan.points.keys.push_back(fmt::format("stage.{}.until.{}", key_part(last.name), wanted.observable));
        errors.push_back(fmt::format("{}", wanted.error * std::sqrt(static_cast<double>(replicas))));
    }
    for (const std::string& setting : settings) {
        const std::vector<std::string> key = setting_key(setting.substr(0, setting.find('=')));
        const auto is_varied = [&](const std::string& varied) { return setting_key(varied) == key; };
        if (std::ranges::none_of(plan.points.keys, is_varied)) {
            plan.settings.push_back(setting);
        }
    }
    for (Index k = 1; k <= replicas; ++k) {
        std::vector<std::string> values{fmt::format("{}", replica_seed(seed_of(deck), k))};
        values.insert(values.end(), errors.begin(), errors.end());
        plan.points.values.push_back(std::move(values));
    }
    return plan;
}

std::string why_all_the_same(const Deck& deck, const Start& start) {
    const auto draws = [](const Stage& stage) {
        return stage.barostat || (stage.thermostat && !stage.thermostat->plugin.deterministic);
    };
    if (!keeps_velocities(deck.system(), start) || std::ranges::any_of(deck.stages, draws)) {
        return "";
    }
    return "all replicas would be the same run: it starts with the velocities of its file, and no stage draws random "
           "numbers. Draw the velocities (velocities = \"maxwell\" in [system]), or take a stochastic thermostat";
}

Document replicas_report(const Deck& deck, const std::vector<ChildRun>& children, const fs::path& directory) {
    std::vector<FoundRun> runs;
    runs.reserve(children.size());
    for (const ChildRun& child : children) {
        runs.push_back(found_run(child));
    }
    std::vector<ObservableAverage> averages;
    std::vector<MergedMean> means;
    for (const Found& first : runs.front().observables) {
        if (const auto both = merged(first, runs)) {
            averages.push_back(both->average);
            means.push_back(both->mean);
        }
    }
    Data observables = observables_data(averages, deck.units);
    for (std::size_t k = 0; k < averages.size(); ++k) {
        observables[averages[k].name]["standard_error_within"] = means[k].within;
        observables[averages[k].name]["standard_error_between"] = means[k].between;
    }
    const std::vector<std::string> doubts = doubts_of(runs, children);
    std::vector<std::string> warnings = doubts;
    for (const ObservableAverage& average : averages) {
        if (is_in_table(average) && !average.remark.empty()) {
            warnings.push_back(fmt::format("{}: {}", average.name, average.remark));
        }
    }
    Data list = Data::list();
    for (std::size_t k = 1; k <= children.size(); ++k) {
        list.push_back(Data(replica_seed(seed_of(deck), static_cast<Index>(k))));
    }
    std::string text = fmt::format("{}\n{} replicas, merged\n\n", title_line(deck), children.size());
    text += observables_table(averages, deck.units) + samples_footnote();
    for (const std::string& doubt : doubts) {
        text += wrapped("  warning: " + doubt, screen_columns, 4) + '\n';
    }
    text += fmt::format("\nfiles: {}\n", directory.string());
    return {{{"title", deck.title},
             {"kind", "replicas"},
             {"replicas", static_cast<Index>(children.size())},
             {"seeds", list},
             {"observables", observables},
             {"doubts", doubts},
             {"warnings", warnings}},
            text};
}

void write_replicas(const Document& report, const std::vector<ChildRun>& runs, const OpenDirectory& directory) {
    for (const char* name : merged_tables) {
        std::vector<DataTable> tables;
        std::vector<double> samples;
        for (const ChildRun& run : runs) {
            const fs::path path = run.directory / fmt::format("{}.csv", name);
            if (!files::exists(path)) {
                break;
            }
            tables.push_back(read_csv(path));
            const FoundRun found = found_run(run);
            samples.push_back(found.observables.empty() ? 1.0 : found.observables.front().mean.samples);
        }
        if (tables.size() == runs.size()) {
            const DataTable merged = merged_table(tables, samples);
            if (!merged.rows.empty()) {
                write_file_atomically(directory / fmt::format("{}.csv", name), to_csv(merged));
            }
        }
    }
    write_file_atomically(directory / "results.json", to_json(report.data) + "\n");
    write_file_atomically(directory / "results.txt", report.text);
}

}  // namespace ljmd
