#include "ljmd/app/stage_sense.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

#include "ljmd/core/text.hpp"

namespace ljmd {

namespace {

constexpr std::size_t longest_name = 64;

void check_name(const Section& stage, std::set<std::string>& names, Diagnostics& diagnostics) {
    const std::string& name = stage.text("name");
    if (!stage.sound("name")) {
        return;
    }
    if (name.empty() || printable(name, longest_name) != name) {
        diagnostics.error(stage.location("name"),
                          fmt::format("'name' in [[stage]] must be 1 to {} printable characters", longest_name));
    } else if (!names.insert(name).second) {
        diagnostics.error(stage.location("name"), fmt::format("two stages are called '{}'", name));
    }
}

}  // namespace

void check_stage_names(const std::vector<Section>& stages, Diagnostics& diagnostics) {
    std::set<std::string> names;
    double sum = 0.0;
    for (const Section& stage : stages) {
        check_name(stage, names, diagnostics);
        sum += static_cast<double>(stage.integer("steps"));
    }
    if (sum > 0x1p62) {
        diagnostics.error(stages.front().location("steps"), "the steps of all stages add up to more than 2^62");
    }
}

}  // namespace ljmd
