#include "ljmd/run/run_in_directory.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <variant>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/deck/deck_system.hpp"
#include "ljmd/deck/fluid.hpp"
#include "ljmd/io/formats/extended_xyz_writer.hpp"
#include "ljmd/run/given/given_record.hpp"
#include "ljmd/run/held_run.hpp"
#include "ljmd/run/run.hpp"
#include "ljmd/run/run_directory.hpp"
#include "ljmd/run/run_lock.hpp"
#include "ljmd/run/spec_deck.hpp"

namespace ljmd {

namespace {

constexpr const char* language = "C++";

/// Passes on what it hears, and keeps the warnings for the results.
class Relay : public RunListener {
  public:
    explicit Relay(RunListener* listener) : listener_(listener) {}

    void stage_begins(const Stage& stage) override {
        if (listener_ != nullptr) {
            listener_->stage_begins(stage);
        }
    }
    void step_done(Index step) override {
        if (listener_ != nullptr) {
            listener_->step_done(step);
        }
    }
    void errors(const std::vector<ErrorSoFar>& errors) override {
        if (listener_ != nullptr) {
            listener_->errors(errors);
        }
    }
    void warning(const std::string& text) override {
        warnings.push_back(text);
        if (listener_ != nullptr) {
            listener_->warning(text);
        }
    }

    std::vector<std::string> warnings;

  private:
    RunListener* listener_;
};

/// A text for decks, where Lennard-Jones stands in for a formula of the program; without its external force.
std::string stand_in_text(FluidSpec spec, const RunFiles& files, Precision precision,
                          const std::filesystem::path& start) {
    std::string text;
    require_no_mistakes(spec, precision);  // while it is known what the program gives
    if (spec.potential.is_custom()) {
        text = fmt::format(
            "# The pair potential is {}, a formula of a program in C++: that in [potential] stands in for it.\n",
            in_quotes(spec.potential.formula()));
        spec.potential = PairPotential::lennard_jones(spec.potential.truncation(), spec.potential.cutoff());
    }
    spec.external = nullptr;
    return text + deck_text(spec, files, precision, start);
}

/// The deck that says the same. Nothing is read for it.
Deck deck_of(const FluidSpec& spec, const std::filesystem::path& directory, const DirectoryOptions& options,
             Precision precision) {
    const std::string text = stand_in_text(spec, options.files, precision, directory / given_start_name);
    GivenParts given{.by = language, .observers = records_of(options.observers), .external = name_of(spec.external)};
    if (spec.potential.is_custom()) {
        given.potential = given_potential(spec.potential);
    }
    Diagnostics diagnostics;
    auto deck = load_deck_text("(a FluidSpec)", text, {}, true, diagnostics, std::move(given));
    if (!deck) {
        throw InputError(diagnostics.errors_without_places());
    }
    deck->directory = directory;
    deck->start_at_hand = true;
    return std::move(*deck);
}

/// Write the configuration that a run starts from, so that one that reads it starts from the same bits.
void keep(const Configuration& given, const Box& box, const OutputPlace& place) {
    State state(static_cast<Index>(given.positions.size()), box);
    place_configuration(state, given);
    write_configuration(place, state, !given.velocities.empty());
}

}  // namespace

RunResult run_in_directory(const FluidSpec& spec, const std::filesystem::path& directory,
                           const DirectoryOptions& options, const Execution& execution) {
    if (directory.empty()) {
        throw InputError("the name of the directory is empty");
    }
    Relay relay(options.listener);
    const auto warn = [&relay](const std::string& text) { relay.warning(text); };
    Deck deck = deck_of(spec, directory, options, execution.precision());
    check_directory(deck, options.replace);
    FluidSpec told = fluid_spec(deck);
    told.start = spec.start;
    told.external = spec.external;
    // Made before any file is touched: if this fails, an earlier run must not be lost.
    FluidSystem fluid = make_fluid(told, execution, warn);
    RunLock lock(deck, options.replace, warn);
    if (const auto* given = std::get_if<Configuration>(&spec.start)) {
        keep(*given, box_of(spec), deck.outputs() / given_start_name);
    }
    const RunControl control{.interruption = options.interruption,
                             .has_begun = [&lock] { lock.has_begun(); },
                             .observers = options.observers};
    RunResult result = lock.run([&] { return run_deck(deck, fluid, relay, control); });
    lock.warn_if_moved();
    result.warnings = relay.warnings;
    return result;
}

RunResult resume_in_directory(const std::filesystem::path& directory, const ResumedDirectoryOptions& options) {
    if (options.more_steps < 0 || options.threads < 0) {
        throw InputError(
            fmt::format("{} more steps, {} threads: allowed are 0 and more", options.more_steps, options.threads));
    }
    Relay relay(options.listener);
    HeldRun run(
        directory, options.more_steps, options.threads, [&relay](const std::string& text) { relay.warning(text); },
        {.by = language, .potential = options.potential, .observers = options.observers, .external = options.external});
    require_fluid(run.deck(), fmt::format("{} holds a run of few bodies, not of a fluid", directory.string()));
    for (const std::string& warning : run.warnings()) {
        relay.warning(warning);
    }
    AnySystem system =
        empty_system(run.deck(), run.checkpoint().atoms, run.checkpoint().edges, run.execution(), options.external);
    auto& fluid = std::get<FluidSystem>(system);
    const RunControl control{
        .interruption = options.interruption, .continuation = run.take(), .observers = options.observers};
    RunResult result = run_deck(run.deck(), fluid, relay, control);
    run.warn_if_moved();
    result.warnings = relay.warnings;
    return result;
}

}  // namespace ljmd
