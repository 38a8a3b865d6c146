#include "ljmd/run/run_record.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/deck/deck_system.hpp"
#include "ljmd/execution/ranks.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/io/files/replacement_file.hpp"
#include "ljmd/io/formats/extended_xyz_writer.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "ljmd/io/tables/pair_table_file.hpp"
#include "ljmd/run/given/given_record.hpp"

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

std::string deck_hash(const Deck& deck) {
    std::string text = deck.source;
    for (const std::string& setting : deck.settings) {
        text += '\n' + setting;
    }
    if (deck.given.potential) {
        text += '\n' + deck.given.potential->checksum;
    }
    return fmt::format("xxh3:{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::unique_ptr<TrajectoryWriter> open_trajectory(const Deck& deck, const State& first,
                                                  const std::optional<Continuation>& continuation) {
    if (!deck.trajectory) {
        return nullptr;
    }
    const std::string& format = deck.trajectory->format;
    return make_trajectory_writer(format, first,
                                  {.path = deck.outputs() / fmt::format("trajectory.{}", format),
                                   .velocities = deck.trajectory->velocities,
                                   .forces = deck.trajectory->forces,
                                   .energies = deck.trajectory->energies,
                                   .si = deck.trajectory->si() ? deck.units : std::nullopt,
                                   .creator_version = build_info().version,
                                   .author = user(),
                                   .title = deck.title,
                                   .kept = kept(continuation, &CommittedOutputs::trajectory)});
}

std::string save_failure(const Deck& deck, const State& state) {
    const std::string name = "failed.xyz";
    try {
        write_configuration(deck.outputs() / name, state, true);
    } catch (const FileError&) {
        return {};
    }
    return fmt::format("\n  the configuration is in {}", (deck.directory / name).string());
}

/// By which rule the digits are made; null where a function of the calling program takes part, or GSL, whose last
/// digits depend on its compiler.
Data digits_of(const Deck& deck, const Execution& execution) {
    const bool by_gsl = std::ranges::any_of(
        deck.stages, [](const Stage& stage) { return find_integrator(stage.integrator.name).adaptive; });
    if (by_gsl || deck.given.potential || !deck.given.external.empty()) {
        return nullptr;
    }
    return digits_rule(deck.kind() == DeckKind::few_body ? SimdLevel::portable : execution.simd(),
                       execution.precision());
}

RunRecord::RunRecord(const Deck& deck, Execution execution, const std::optional<Continuation>& continuation)
    : deck_(deck),
      execution_(std::move(execution)),
      parts_(continuation ? continuation->earlier : EarlierParts{.began = now(), .resumed_at_steps = {}}) {
    // The table first: what the record names is there.
    if (!continuation && deck_.given.potential && deck_.given.potential->table) {
        write_pair_table(deck_.outputs() / pair_table_name, *deck_.given.potential->table);
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
    const bool few_body = deck_.kind() == DeckKind::few_body;
    Data record = {{"program", "ljmd"},
                   {"version", build.version},
                   {"commit", build.commit},
                   {"compiler", build.compiler + " " + build.compiler_version},
                   {"build_type", build.build_type},
                   {"flags", build.flags},
                   {"simd", few_body ? Data(nullptr) : Data(name(execution_.simd()))},
                   {"precision", name(execution_.precision())},
                   {"digits", digits_of(deck_, execution_)},
                   {"threads", execution_.threads()},
                   {"host", host()},
                   {"title", deck_.title},
                   {"deck_file", deck_.path},
                   {"deck", deck_.source},
                   {"settings", deck_.settings},
                   {"deck_hash", deck_hash(deck_)},
                   {"given", given_data(deck_.given)},
                   {"kind", kind_name(deck_)},
                   {"seed", few_body ? Data(nullptr) : Data(deck_.system().seed)},
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
    if (deck_.units) {
        record["argon"] = {{"sigma_nm", deck_.units->nanometre()},
                           {"epsilon_K", deck_.units->kelvin()},
                           {"mass_u", deck_.units->dalton()},
                           {"tau_ps", deck_.units->picosecond()}};
    }
    const std::string text = to_json(record);
    write_file_atomically(deck_.outputs() / "run.json", text + "\n");
}

}  // namespace ljmd
