#include "study/reference/energy_kept.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/tables/json_file.hpp"

namespace ljmd {

namespace {

double number_or_zero(const Data& stage, const char* key) {
    const Data* value = stage.find(key);
    return value != nullptr && value->is_number() ? value->number() : 0.0;
}

/// Of the stages that are sampled, the worst.
double uncertainty_of(const Data& results, double temperature) {
    double largest = 0.0;
    for (const Data& stage : results.at("stages").items()) {
        if (stage.at("sampled").flag()) {
            const double time = number_or_zero(stage, "steps") * number_or_zero(stage, "time_step");
            const double moved = std::abs(number_or_zero(stage, "energy_drift")) * time / 2.0;
            largest = std::max(largest, moved / (1.5 * temperature) + number_or_zero(stage, "time_step_error"));
        }
    }
    return largest;
}

}  // namespace

double temperature_uncertainty(const std::vector<std::filesystem::path>& runs, double temperature) {
    double largest = 0.0;
    for (const std::filesystem::path& run : runs) {
        largest = std::max(largest, read_json(run / "results.json", "the results of a run", [&](const Data& results) {
                               return uncertainty_of(results, temperature);
                           }));
    }
    return largest;
}

std::string energy_warning(double uncertainty) {
    if (!(uncertainty > noticeable_uncertainty)) {
        return "";
    }
    return fmt::format(
        "the runs at constant energy do not keep it exactly: the temperature that transport coefficients belong to is "
        "uncertain by {:.2g} %{}",
        100.0 * uncertainty, uncertainty > largest_uncertainty ? ", and none is given" : "");
}

}  // namespace ljmd
