#include "study/reference/merged_observables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/tables/json_file.hpp"

namespace ljmd {

namespace {

double number_or_nan(const Data* value) {
    return value != nullptr && value->is_number() ? value->number() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<MergedObservable> merged_observables(const std::filesystem::path& directory) {
    return read_json(directory / "results.json", "the results of replicas", [](const Data& results) {
        std::vector<MergedObservable> found;
        for (const auto& [name, entry] : results.at("observables").members()) {
            const Data* converged = entry.find("error_is_converged");
            const Data* remark = entry.find("remark");
            found.push_back({name, entry.at("unit").text(), number_or_nan(&entry.at("mean")),
                             number_or_nan(entry.find("standard_error")),
                             number_or_nan(entry.find("independent_samples")),
                             converged != nullptr && converged->flag(), remark != nullptr ? remark->text() : ""});
        }
        return found;
    });
}

const MergedObservable* find_merged(const std::vector<MergedObservable>& all, std::string_view name) {
    const auto found = std::ranges::find(all, name, &MergedObservable::name);
    return found == all.end() || std::isnan(found->mean) ? nullptr : &*found;
}

}  // namespace ljmd
