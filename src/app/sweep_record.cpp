#include "ljmd/app/sweep_record.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "ljmd/app/json_file.hpp"
#include "ljmd/app/run_directory.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/file_system.hpp"
#include "ljmd/io/output_file.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

std::string record_json(const SweepPlan& plan) {
    using Json = nlohmann::ordered_json;
    const std::vector<std::string> names = point_names(plan.points);
    Json points = Json::array();
    for (std::size_t k = 0; k < names.size(); ++k) {
        points.push_back({{"name", names[k]}, {"values", plan.points.values[k]}});
    }
    const Json record = {{"program", "ljmd"},         {"deck_file", plan.deck_file}, {"deck", plan.deck},
                         {"settings", plan.settings}, {"keys", plan.points.keys},    {"points", points}};
    // The path of a deck need not be UTF-8, as JSON must.
    return record.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// What the sweep in a directory has and this one has not; empty when they are the same.
std::string difference(const SweepPlan& recorded, const SweepPlan& plan) {
    return recorded.deck != plan.deck           ? "another deck"
           : recorded.settings != plan.settings ? "other settings (--set)"
           : recorded.points != plan.points     ? "other points"
                                                : "";
}

void remove_run(const ChildRun& run) {
    if (files::exists(run.directory / "run.json")) {
        prepare_directory(run.directory);  // takes away what a run writes, and nothing else
    }
    files::try_to_remove(run.log);
    files::try_to_remove(run.directory);  // unless something else is in it
}

/// Remove what a sweep has written and this one has no use for.
void remove_sweep(const SweepPlan& old, const SweepPlan& plan, const fs::path& directory) {
    std::map<std::string, std::vector<std::string>> wanted;
    for (const ChildRun& run : sweep_runs(plan, directory)) {
        wanted.emplace(run.name, run.settings);
    }
    for (const ChildRun& run : sweep_runs(old, directory)) {
        const auto same_name = wanted.find(run.name);
        if (old.deck != plan.deck || same_name == wanted.end() || same_name->second != run.settings) {
            remove_run(run);
        }
    }
    files::try_to_remove(directory / "sweep.csv");
}

}  // namespace

std::vector<ChildRun> sweep_runs(const SweepPlan& plan, const fs::path& directory) {
    const fs::path folder = directory / "points";
    const std::vector<std::string> names = point_names(plan.points);
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
    return read_json(path, "the record of a sweep", [](const nlohmann::ordered_json& record) {
        SweepPlan plan{record.at("deck_file").get<std::string>(),
                       record.at("deck").get<std::string>(),
                       record.at("settings").get<std::vector<std::string>>(),
                       {record.at("keys").get<std::vector<std::string>>(), {}}};
        for (const auto& point : record.at("points")) {
            plan.points.values.push_back(point.at("values").get<std::vector<std::string>>());
            if (plan.points.values.back().size() != plan.points.keys.size()) {
                throw WrongJson("a point has not a value for each key");
            }
        }
        return plan;
    });
}

void prepare_sweep(const SweepPlan& plan, const fs::path& directory, bool force) {
    for (const ChildRun& run : sweep_runs(plan, directory)) {
        check_log(run);
    }
    const auto recorded = recorded_sweep(directory);
    if (!recorded) {
        for (const char* name : {"sweep.csv", "points"}) {
            if (files::exists(directory / name)) {
                throw InputError(
                    fmt::format("{} holds '{}', but no sweep. Nothing was run.\n  choose another directory "
                                "with --out",
                                directory.string(), name));
            }
        }
    } else if (const std::string other = difference(*recorded, plan); !other.empty()) {
        if (!force) {
            throw InputError(
                fmt::format("{} holds a sweep with {}. Nothing was run.\n  choose another directory with "
                            "--out, or replace it with --force",
                            directory.string(), other));
        }
        remove_sweep(*recorded, plan, directory);
    }
    for (const ChildRun& run : sweep_runs(plan, directory)) {
        if (!force && holds_another_run(run)) {
            throw InputError(
                fmt::format("{} holds a run that is not of this sweep; --force makes it anew", run.directory.string()));
        }
    }
    write_file_atomically(directory / "sweep.json", record_json(plan));
    make_directory(directory / "points");
    write_file_atomically(directory / "points" / "deck.toml", plan.deck);
}

}  // namespace ljmd
