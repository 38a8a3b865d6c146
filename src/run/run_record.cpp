#include "run/run_record.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "deck/deck_system.hpp"
#include "execution/ranks.hpp"
#include "integrators/integrator.hpp"
#include "io/files/replacement_file.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "io/tables/json_text.hpp"
#include "io/tables/pair_table_file.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "run/given/given_record.hpp"

namespace ljmd {

namespace {

std::string now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

std::string host() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string user() {
    std::array<char, 256> name{};
    return getlogin_r(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

std::string deck_hash(const RunPlan& plan) {
    std::string text = plan.source;
    for (const std::string& setting : plan.settings) {
        text += '\n' + setting;
    }
    if (plan.given.potential) {
        text += '\n' + plan.given.potential->checksum;
    }
    return fmt::format("xxh3:{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::unique_ptr<TrajectoryWriter> open_trajectory(const RunPlan& plan, const State& first,
                                                  const std::optional<Continuation>& continuation) {
    if (!plan.trajectory) {
        return nullptr;
    }
    const std::string& format = plan.trajectory->format;
    return make_trajectory_writer(format, first,
                                  {.path = plan.outputs() / fmt::format("trajectory.{}", format),
                                   .velocities = plan.trajectory->velocities,
                                   .forces = plan.trajectory->forces,
                                   .energies = plan.trajectory->energies,
                                   .si = plan.trajectory->si() ? plan.units() : std::nullopt,
                                   .creator_version = build_info().version,
                                   .author = user(),
                                   .title = plan.title,
                                   .kept = kept(continuation, &CommittedOutputs::trajectory)});
}

std::string save_failure(const RunPlan& plan, const State& state) {
    const std::string name = "failed.xyz";
    try {
        write_configuration(plan.outputs() / name, state, true);
    } catch (const FileError&) {
        return {};
    }
    return fmt::format("\n  the configuration is in {}", (plan.directory / name).string());
}

/// By which rule the digits are made; null where a function of the calling program takes part, or GSL, whose last
/// digits depend on its compiler.
Data digits_of(const RunPlan& plan, const Execution& execution) {
    const bool by_gsl = std::ranges::any_of(
        plan.stages(), [](const Stage& stage) { return find_integrator(stage.integrator.name).adaptive; });
    if (by_gsl || plan.given.potential || !plan.given.external.empty()) {
        return nullptr;
    }
    return digits_rule(!plan.is_fluid() ? SimdLevel::portable : execution.simd(), execution.precision());
}

RunRecord::RunRecord(const RunPlan& plan, Execution execution, const std::optional<Continuation>& continuation)
    : plan_(plan),
      execution_(std::move(execution)),
      parts_(continuation ? continuation->earlier : EarlierParts{.began = now(), .resumed_at_steps = {}}) {
    // The table first: what the record names is there.
    if (!continuation && plan_.given.potential && plan_.given.potential->table) {
        write_pair_table(plan_.outputs() / pair_table_name, *plan_.given.potential->table);
    }
    write(false, 0.0, std::nullopt);
}

void RunRecord::finish(double seconds, const std::optional<PhaseSeconds>& phases,
                       const std::optional<UntilEnd>& until) {
    until_ = until;
    write(true, seconds, phases);
}

void RunRecord::write(bool finished, double seconds, const std::optional<PhaseSeconds>& phases) const {
    const BuildInfo& build = build_info();
    const bool few_body = !plan_.is_fluid();
    Data record = {{"program", "ljmd"},
                   {"version", build.version},
                   {"commit", build.commit},
                   {"compiler", build.compiler + " " + build.compiler_version},
                   {"build_type", build.build_type},
                   {"flags", build.flags},
                   {"simd", few_body ? Data(nullptr) : Data(name(execution_.simd()))},
                   {"precision", name(execution_.precision())},
                   {"digits", digits_of(plan_, execution_)},
                   {"threads", execution_.threads()},
                   {"host", host()},
                   {"title", plan_.title},
                   {"deck_file", plan_.path},
                   {"deck", plan_.source},
                   {"settings", plan_.settings},
                   {"deck_hash", deck_hash(plan_)},
                   {"given", given_data(plan_.given)},
                   {"kind", kind_name(plan_)},
                   {"seed", few_body ? Data(nullptr) : Data(std::get<FluidSpec>(plan_.spec).seed)},
                   {"units", few_body ? "the deck's own" : "reduced"},
                   {"began", parts_.began},
                   {"ended", finished ? Data(now()) : Data(nullptr)},
                   {"finished", finished},
                   {"seconds_in_time_loop", finished ? Data(seconds) : Data(nullptr)},
                   {"resumed_at_steps", parts_.resumed_at_steps},
                   {"steps_added", parts_.steps_added},
                   {"last_stage_steps", parts_.last_stage_steps}};
    if (const Ranks& ranks = execution_.ranks(); !ranks.alone()) {
        record["ranks"] = ranks.size();
    }
    if (until_) {
        record["until_reached"] = until_->reached;
        record["steps_taken"] = until_->steps;
    }
    if (phases) {
        record["seconds_per_phase"] = phases_data(*phases);
    }
    record["argon"] = nullptr;
    if (plan_.units()) {
        record["argon"] = {{"sigma_nm", plan_.units()->nanometre()},
                           {"epsilon_K", plan_.units()->kelvin()},
                           {"mass_u", plan_.units()->dalton()},
                           {"tau_ps", plan_.units()->picosecond()}};
    }
    const std::string text = to_json(record);
    write_file_atomically(plan_.outputs() / "run.json", text + "\n");
}

}  // namespace ljmd
