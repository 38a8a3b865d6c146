#include "run/recorded_results.hpp"

#include <fmt/format.h>

#include <limits>

#include "deck/deck_schema.hpp"
#include "io/tables/json_file.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

namespace {

constexpr std::size_t most_doubts = 1000;

/// The members of an object; a list is refused.
const Data::Object& members_of(const Data& value, std::string_view name) {
    if (!value.is_object()) {
        throw WrongData(fmt::format("'{}' is no object", name));
    }
    return value.members();
}

double number_of(const Data& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.number();
}

std::vector<ObservedMean> means_of(const Data& results) {
    std::vector<ObservedMean> found;
    for (const auto& [name, entry] : members_of(results.at("observables"), "observables")) {
        const Data* remark = entry.find("remark");
        found.push_back({name, number_of(entry.at("mean")), number_of(entry.at("standard_error")),
                         remark == nullptr ? "" : remark->text()});
    }
    if (const Data* analyses = results.find("analysis")) {
        for (const auto& [analysis, findings] : members_of(*analyses, "analysis")) {
            for (const auto& [name, entry] : members_of(findings, analysis)) {
                found.push_back({fmt::format("{}_{}", analysis, name), number_of(entry.at("value")),
                                 number_of(entry.at("standard_error"))});
            }
        }
    }
    if (found.size() > max_json_keys) {
        throw WrongData(fmt::format("it has more than {} observables", max_json_keys));
    }
    return found;
}

std::vector<RecordedStage> stages_of(const Data& results) {
    std::vector<RecordedStage> stages;
    for (const Data& stage : results.at("stages").items()) {
        stages.push_back({stage.at("sampled").flag(), integer_of(stage.at("first_step"), "first_step", 0, max_steps),
                          integer_of(stage.at("steps"), "steps", 0, max_steps)});
    }
    return stages;
}

std::vector<std::string> doubts_of(const Data& results) {
    const Data* found = results.find("doubts");  // only a fluid has them
    return found == nullptr ? std::vector<std::string>{} : texts_of(*found, "doubts", most_doubts);
}

}  // namespace

RecordedResults read_results(const std::filesystem::path& path) {
    return read_json(path, "the result of a run", [](const Data& results) -> RecordedResults {
        return {means_of(results), stages_of(results), doubts_of(results)};
    });
}

}  // namespace ljmd
