#include "ljmd/deck/deck_stages.hpp"

namespace ljmd {

namespace {

/// The plug-in that a table of a stage chooses; nothing without the table, or if its type is wrong.
template <class Find>
auto chosen_in(const Section& stage, const char* key, const Find& find)
    -> std::optional<decltype(choose(find(""), stage))> {
    if (!stage.has(key) || !stage.sound(key) || !stage.section(key).sound("type")) {
        return std::nullopt;
    }
    const Section& table = stage.section(key);
    return choose(find(table.text("type")), table);
}

Stage stage_of(const Section& section, const Section& root) {
    Stage stage{.name = section.text("name"),
                .integrator = choose(find_integrator(section.text("integrator")), section),
                .time_step = section.number("time_step"),
                .steps = section.integer("steps"),
                .sample = section.flag("sample"),
                .reverse = section.flag("reverse"),
                .thermostat = chosen_in(section, "thermostat", find_thermostat),
                .barostat = chosen_in(section, "barostat", find_barostat),
                .seed = root.has("system") ? static_cast<std::uint64_t>(root.section("system").integer("seed")) : 0};
    // That a thermostat lacks its temperature is reported elsewhere: the stand-in breaks no rule.
    stage.temperature = stage_temperature(section, root).value_or(stage.thermostat ? 1.0 : 0.0);
    return stage;
}

/// Whether a number is there, and is not a stand-in.
bool is_given(const Section& section, const char* key) {
    return section.has(key) && section.sound(key);
}

}  // namespace

std::vector<Stage> stages_of(const Section& root) {
    std::vector<Stage> stages;
    for (const Section& section : root.sections("stage")) {
        stages.push_back(stage_of(section, root));
    }
    return stages;
}

std::optional<double> stage_temperature(const Section& stage, const Section& root) {
    if (stage.has("temperature")) {
        return is_given(stage, "temperature") ? std::optional(stage.number("temperature")) : std::nullopt;
    }
    return root.has("system") && is_given(root.section("system"), "temperature")
               ? std::optional(root.section("system").number("temperature"))
               : std::nullopt;
}

}  // namespace ljmd
