#include "study/replicas.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "core/text.hpp"
#include "deck/fluid.hpp"
#include "input/deck_setting.hpp"
#include "integrators/thermostat.hpp"
#include "io/files/file_system.hpp"
#include "io/files/replacement_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "io/tables/json_file.hpp"
#include "ljmd/core/errors.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "run/results.hpp"
#include "run/run_report.hpp"
#include "study/replica_merge.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, 2> merged_tables{"rdf", "sk"};  // those whose rows are averages at fixed places
/// As many as independent samples are asked for elsewhere: the scatter of so many runs is known to 18 %.
constexpr std::size_t enough_runs = 16;

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

/// Without the note that the error bar is a guess, which is told of the merged one.
std::string without_guess(const std::string& remark) {
    const std::size_t at = remark.find(guessed_error);
    return at == std::string::npos ? remark : remark.substr(0, at >= 2 ? at - 2 : 0);
}

/// An observable of one run, from its results.json.
struct Found {
    std::string name;
    std::string unit;
    std::optional<ReplicaMean> mean;  ///< empty if it has no value
    double independent;
    std::string remark;
};

struct FoundRun {
    std::vector<Found> observables;
    std::vector<std::string> doubts;

    /// Samples of the first observable that has a value; 1 if none has.
    [[nodiscard]] double samples() const {
        const auto valued =
            std::ranges::find_if(observables, [](const Found& found) { return found.mean.has_value(); });
        return valued != observables.end() ? valued->mean->samples : 1.0;
    }
};

FoundRun found_run(const ChildRun& run) {
    return read_json(run.directory / "results.json", "the results of a run", [](const Data& results) {
        FoundRun found;
        for (const auto& [name, entry] : results.at("observables").members()) {
            std::optional<ReplicaMean> mean;
            if (!entry.at("mean").is_null()) {
                mean = {entry.at("mean").number(), number_or(entry.find("standard_error"), no_number),
                        static_cast<double>(integer_of(entry.at("samples"), "samples", 1, max_steps)),
                        entry.at("error_is_converged").flag()};
            }
            const Data* remark = entry.find("remark");
            found.observables.push_back({name, entry.at("unit").text(), mean,
                                         number_or(entry.find("independent_samples"), no_number),
                                         remark != nullptr ? without_guess(remark->text()) : ""});
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
    MergedMean mean;  ///< NaN if the observable has no value
};

/// The remarks of the runs on an observable, each once, with the number of runs that have it; of many the first.
std::vector<std::string> remarks_of(const std::vector<const Found*>& runs) {
    std::vector<std::string> remarks;
    for (const Found* run : runs) {
        const auto has_it = [run](const Found* other) { return other->remark == run->remark; };
        const bool first = run == *std::ranges::find_if(runs, has_it);
        if (first && !run->remark.empty()) {
            const auto count = std::ranges::count_if(runs, has_it);
            remarks.push_back(std::cmp_equal(count, runs.size())
                                  ? run->remark
                                  : fmt::format("in {} of {} replicas: {}", count, runs.size(), run->remark));
        }
    }
    if (constexpr std::size_t many = 3; remarks.size() >= many) {
        const auto count = std::ranges::count_if(runs, [](const Found* run) { return !run->remark.empty(); });
        return {fmt::format("{} of {} replicas have remarks, {}", count, runs.size(), remarks.front())};
    }
    return remarks;
}

/// There is no value where a run has none: those that have one are no fair choice of the runs.
/// @param runs   those that have the observable  @param count  of all runs
Merged merged(const std::vector<const Found*>& runs, std::size_t count) {
    const Found& first = *runs.front();
    Merged all{{first.name, symbol_of(first.name), first.unit, std::nullopt},
               {no_number, no_number, no_number, no_number, true}};
    std::vector<std::string> remarks = remarks_of(runs);
    const auto valued =
        static_cast<std::size_t>(std::ranges::count_if(runs, [](const Found* run) { return run->mean.has_value(); }));
    if (valued < count) {
        if (valued > 0) {
            remarks.insert(remarks.begin(), fmt::format("{} of {} replicas have no value", count - valued, count));
        }
        all.average.remark = fmt::format("{}", fmt::join(remarks, "; "));
        return all;
    }
    std::vector<ReplicaMean> means;
    means.reserve(runs.size());
    double independent = 0.0;
    double samples = 0.0;
    for (const Found* run : runs) {
        means.push_back(*run->mean);
        independent += run->independent;
        samples += run->mean->samples;
    }
    all.mean = merged_mean(means);
    // A larger error counts fewer samples as independent.
    const double larger = all.mean.standard_error / all.mean.within;
    const double counted = std::isfinite(larger) && larger > 0.0 ? independent / (larger * larger) : independent;
    const bool known = std::ranges::all_of(means, &ReplicaMean::converged);
    all.average.estimate = Estimate{all.mean.mean, all.mean.standard_error, std::clamp(counted, 1.0, samples),
                                    static_cast<Index>(samples), known || runs.size() >= enough_runs};
    if (!all.mean.agree) {
        remarks.emplace_back(
            "the replicas differ by more than their errors let expect: its error is from their scatter");
    } else if (!known && runs.size() > 1) {
        const auto guesses = std::ranges::count(means, false, &ReplicaMean::converged);
        remarks.push_back(fmt::format(
            "the error bars of {} of {} replicas are guesses: its error is from their scatter", guesses, runs.size()));
    }
    all.average.remark = fmt::format("{}", fmt::join(remarks, "; "));
    return all;
}

/// All observables, in the order in which the runs have them.
std::vector<Merged> merged_observables(const std::vector<FoundRun>& runs) {
    std::vector<std::string> names;
    std::map<std::string, std::vector<const Found*>> found;
    for (const FoundRun& run : runs) {
        for (const Found& each : run.observables) {
            if (found[each.name].empty()) {
                names.push_back(each.name);
            }
            found[each.name].push_back(&each);
        }
    }
    std::vector<Merged> all;
    all.reserve(names.size());
    for (const std::string& name : names) {
        all.push_back(merged(found[name], runs.size()));
    }
    return all;
}

/// What is to be known of runs that have not the same length; empty if they have.
std::string lengths_of(const std::vector<FoundRun>& runs) {
    const auto [shortest, longest] = std::ranges::minmax_element(runs, {}, &FoundRun::samples);
    if (shortest->samples() == longest->samples()) {
        return "";
    }
    return fmt::format("the replicas have {:.0f} to {:.0f} samples: each counts by its length", shortest->samples(),
                       longest->samples());
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
    const Stage& last = deck.stages().back();
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
        return stage.barostat || (stage.thermostat && !find_thermostat(stage.thermostat->name).deterministic);
    };
    if (!keeps_velocities(deck.system(), start) || std::ranges::any_of(deck.stages(), draws)) {
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
    for (const Merged& each : merged_observables(runs)) {
        averages.push_back(each.average);
        means.push_back(each.mean);
    }
    Data observables = observables_data(averages, deck.units());
    for (std::size_t k = 0; k < averages.size(); ++k) {
        observables[averages[k].name]["standard_error_within"] = means[k].within;
        observables[averages[k].name]["standard_error_between"] = means[k].between;
    }
    std::vector<std::string> doubts = doubts_of(runs, children);
    const std::string lengths = lengths_of(runs);
    const bool end_by_errors = !deck.stages().back().until.empty();
    if (!lengths.empty() && !end_by_errors) {
        doubts.push_back(lengths);
    }
    std::vector<std::string> warnings = doubts;
    for (const ObservableAverage& average : averages) {
        if (const std::string remark = remark_of(average); is_in_table(average) && !remark.empty()) {
            warnings.push_back(fmt::format("{}: {}", average.name, remark));
        }
    }
    Data list = Data::list();
    for (std::size_t k = 1; k <= children.size(); ++k) {
        list.push_back(Data(replica_seed(seed_of(deck), static_cast<Index>(k))));
    }
    std::string text = fmt::format("{}\n{} replicas, merged\n\n", title_line(deck), children.size());
    text += observables_table(averages, deck.units()) + samples_footnote();
    if (!lengths.empty() && end_by_errors) {
        text += wrapped("  " + lengths, screen_columns, 4) + '\n';
    }
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

std::vector<std::string> replica_output_names() {
    std::vector<std::string> names{"results.json", "results.txt"};
    std::ranges::transform(merged_tables, std::back_inserter(names),
                           [](const char* name) { return fmt::format("{}.csv", name); });
    return names;
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
            samples.push_back(found_run(run).samples());
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
