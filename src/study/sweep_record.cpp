#include "study/sweep_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/replacement_file.hpp"
#include "io/tables/json_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"
#include "run/recorded_run.hpp"
#include "run/run_directory.hpp"
#include "study/replicas.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Points are named after their values, replicas after their numbers.
std::vector<std::string> run_names(const SweepPlan& plan) {
    if (plan.replicas == 0) {
        return point_names(plan.points);
    }
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(plan.replicas));
    const std::size_t digits = fmt::format("{}", plan.replicas).size();
    for (Index k = 1; k <= plan.replicas; ++k) {
        names.push_back(fmt::format("replica-{:0{}}", k, digits));
    }
    return names;
}

std::string record_json(const SweepPlan& plan) {
    const std::vector<std::string> names = run_names(plan);
    Data points = Data::list();
    for (std::size_t k = 0; k < names.size(); ++k) {
        points.push_back({{"name", names[k]}, {"values", plan.points.values[k]}});
    }
    Data record = {{"program", "ljmd"},         {"deck_file", plan.deck_file}, {"deck", plan.deck},
                   {"settings", plan.settings}, {"keys", plan.points.keys},    {"points", points}};
    if (plan.replicas > 0) {
        record["replicas"] = plan.replicas;
        record["steps_added"] = plan.steps_added;
    }
    return to_json(record) + "\n";
}

/// How the recorded sweep differs from this one; empty if they are the same.
std::string difference(const SweepPlan& recorded, const SweepPlan& plan) {
    return recorded.deck != plan.deck           ? "another deck"
           : recorded.settings != plan.settings ? "other settings (--set)"
           : recorded.replicas != plan.replicas ? "another number of replicas"
           : recorded.points != plan.points     ? "other points"
                                                : "";
}

/// @throws WrongData unless `ljmd sweep` can have written them
void require_sound(const SweepPoints& points, const std::vector<std::string>& settings) {
    Diagnostics mistakes;
    check_keys(points.keys, settings, {}, mistakes);
    if (mistakes.has_errors()) {
        throw WrongData(mistakes.entries().front().message);
    }
    if (points.keys.empty() || points.values.empty() || points.values.size() > max_points) {
        throw WrongData(fmt::format("{} keys and {} points, allowed: one key at least, and 1 to {} points",
                                    points.keys.size(), points.values.size(), max_points));
    }
    std::set<std::vector<std::string>> known;
    for (const std::vector<std::string>& values : points.values) {
        if (values.size() != points.keys.size() || std::ranges::count(values, "") > 0) {
            throw WrongData("a point has not a value for each key");
        }
        if (!known.insert(values).second) {
            throw WrongData("a point stands twice");
        }
    }
}

/// Remove the files of a run, and nothing else.
void remove_run(const ChildRun& run) {
    if (files::exists(run.directory / "run.json")) {
        prepare_directory(run.directory);
        files::try_to_remove(run.directory);  // if it is empty
    }
    files::try_to_remove(run.log);
}

/// Runs of an old sweep that a new one cannot use.
std::vector<ChildRun> unwanted_runs(const SweepPlan& old, const SweepPlan& plan, const fs::path& directory) {
    std::map<std::string, std::vector<std::string>> wanted;
    for (const ChildRun& run : sweep_runs(plan, directory)) {
        wanted.emplace(run.name, run.settings);
    }
    std::vector<ChildRun> runs;
    for (ChildRun& run : sweep_runs(old, directory)) {
        const auto same_name = wanted.find(run.name);
        if (old.deck != plan.deck || same_name == wanted.end() || same_name->second != run.settings) {
            runs.push_back(std::move(run));
        }
    }
    return runs;
}

/// A sweep that failed before its record was in place leaves `points` empty: that is not in the way of another one.
bool is_in_the_way(const fs::path& path) {
    const bool left_over =
        path.filename() == "points" && files::type_of(path) == fs::file_type::directory && files::list(path).empty();
    return files::is_taken(path) && !left_over;
}

/// Runs of another sweep that must be replaced; nothing if there is no other sweep. Changes nothing.
/// @throws InputError, DataError  as prepare_sweep()
std::optional<std::vector<ChildRun>> runs_to_replace(const SweepPlan& plan, const fs::path& directory, bool force) {
    const auto recorded = recorded_sweep(directory);
    if (!recorded) {
        if (plan.replicas > 0) {
            require_no_outputs(directory, replica_output_names(), force, "Nothing was run");
        }
        for (const char* name : {"sweep.csv", "points"}) {
            if (is_in_the_way(directory / name)) {
                throw InputError(
                    fmt::format("{} holds '{}', but no sweep. Nothing was run.\n  choose another directory "
                                "with --out",
                                directory.string(), name));
            }
        }
        return std::nullopt;
    }
    const std::string other = difference(*recorded, plan);
    if (!other.empty() && !force) {
        throw InputError(
            fmt::format("{} holds a sweep with {}. Nothing was run.\n  choose another directory with "
                        "--out, or replace it with --force",
                        directory.string(), other));
    }
    return other.empty() ? std::nullopt : std::optional(unwanted_runs(*recorded, plan, directory));
}

/// @throws InputError  the files of a run cannot be removed because something else has one of their names
void require_removable(const ChildRun& run) {
    check_places(run);
    static_cast<void>(existing_outputs(run.directory, run_output_names(), "Nothing was run"));
}

}  // namespace

std::vector<ChildRun> sweep_runs(const SweepPlan& plan, const fs::path& directory) {
    const fs::path folder = directory / "points";
    const std::vector<std::string> names = run_names(plan);
    std::vector<ChildRun> runs;
    for (std::size_t point = 0; point < names.size(); ++point) {
        ChildRun run{.name = names[point],
                     .deck = folder / "deck.toml",
                     .source = plan.deck,
                     .settings = plan.settings,
                     .directory = folder / names[point],
                     .log = folder / (names[point] + ".log")};
        const std::vector<std::string> varied = point_settings(plan.points, point);
        run.settings.insert(run.settings.end(), varied.begin(), varied.end());
        runs.push_back(std::move(run));
    }
    return runs;
}

std::optional<SweepPlan> recorded_sweep(const fs::path& directory) {
    const fs::path path = directory / "sweep.json";
    if (!files::is_taken(path)) {
        return std::nullopt;
    }
    return read_json(path, "the record of a sweep", [](const Data& record) {
        SweepPlan plan{record.at("deck_file").text(),
                       record.at("deck").text(),
                       texts_of(record.at("settings"), "settings", max_settings),
                       {texts_of(record.at("keys"), "keys", max_varied_keys), {}}};
        for (const Data& point : record.at("points").items()) {
            plan.points.values.push_back(texts_of(point.at("values"), "values", max_varied_keys));
        }
        if (const Data* replicas = record.find("replicas")) {
            plan.replicas = integer_of(*replicas, "replicas", 1, static_cast<Index>(max_points));
            plan.steps_added = integer_of(record.at("steps_added"), "steps_added", 0, max_steps);
            if (plan.points.values.size() != static_cast<std::size_t>(plan.replicas)) {
                throw WrongData("it has another number of points than of replicas");
            }
        }
        require_sound(plan.points, plan.settings);
        return plan;
    });
}

void record_sweep(const SweepPlan& plan, const OpenDirectory& directory) {
    write_file_atomically(directory / "sweep.json", record_json(plan));
}

void prepare_sweep(const SweepPlan& plan, const OpenDirectory& directory, bool force,
                   const std::function<void(const fs::path&)>& wait) {
    const fs::path& path = directory.path();
    const auto replaced = runs_to_replace(plan, path, force);
    const std::vector<ChildRun> old = replaced.value_or(std::vector<ChildRun>());
    static_cast<void>(existing_outputs(path, {"sweep.json", "sweep.csv"}, "Nothing was run"));
    std::ranges::for_each(old, require_removable);
    const auto is_old = [&](const ChildRun& run) {
        return std::ranges::find(old, run.directory, &ChildRun::directory) != old.end();
    };
    for (const ChildRun& run : sweep_runs(plan, path)) {
        check_places(run);
        if (!force && !is_old(run) && holds_another_run(run)) {
            throw InputError(
                fmt::format("{} holds a run that is not of this sweep; --force makes it anew", run.directory.string()));
        }
    }
    const OpenDirectory points = directory.made_within("points");
    std::optional<DirectoryLock> workers_away;
    if (replaced) {
        workers_away.emplace(points);
    }
    if (replaced || plan.replicas > 0) {
        wait(points.path());
    }
    // The record is on the disk before the first run is removed, and takes its place after the last one was.
    ReplacementFile record(directory / "sweep.json");
    OutputFile file(record);
    file.write(record_json(plan));
    file.close_on_disk();
    remove_left_over(points);
    directory.require_at_its_path();
    std::ranges::for_each(old, remove_run);
    if (force) {
        std::ranges::for_each(sweep_runs(plan, path), forget_another_run);
    }
    if (replaced) {
        files::try_to_remove(path / "sweep.csv");
    }
    record.take_place();
    write_file_atomically(points / "deck.toml", plan.deck);
}

}  // namespace ljmd
