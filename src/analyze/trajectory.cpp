#include "ljmd/analyze/trajectory.hpp"

#include <fmt/format.h>

#include <utility>

#include "analyze/trajectory_analysis.hpp"
#include "deck/deck.hpp"
#include "io/formats/configuration_reader.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/forces/external_force.hpp"
#include "ljmd/run/spec_deck.hpp"
#include "options/toml_writer.hpp"

namespace ljmd {

namespace {

/// What the analyses know of a fluid.
Deck deck_of(FluidSpec fluid) {
    if (fluid.stages.empty()) {
        fluid.stages = {Stage{.name = "frames", .sample = true}};
    }
    GivenParts given;
    if (const PairPotential own = fluid.potential; own.is_custom()) {
        fluid.potential = PairPotential::lennard_jones(own.truncation(), own.cutoff());  // stands in for it in the text
        given.potential = GivenPotential{.name = own.formula(),
                                         .truncation = own.truncation(),
                                         .cutoff = own.cutoff(),
                                         .checksum = "",
                                         .potential = own};
    }
    if (fluid.external) {
        given.external = fluid.external->name();
        fluid.external.reset();
    }
    Diagnostics diagnostics;
    auto deck = load_deck_text("(a FluidSpec)", deck_text(fluid), {}, true, diagnostics);
    diagnostics.throw_if_errors();
    deck->given = std::move(given);
    return std::move(*deck);
}

std::optional<Positions> positions_of(std::optional<bool> wrapped) {
    if (!wrapped) {
        return std::nullopt;
    }
    return *wrapped ? Positions::wrapped : Positions::unwrapped;
}

/// "analysis.rdf.bins=200"
std::vector<std::string> settings_of(const std::vector<Choice>& analyses) {
    std::vector<std::string> all;
    for (const Choice& analysis : analyses) {
        Table table;
        append(analysis.settings, table);
        for (const Entry& entry : table) {
            all.push_back(fmt::format("analysis.{}.{}={}", analysis.name, entry.key, toml_value(entry.value)));
        }
    }
    return all;
}

}  // namespace

struct Trajectory::Parts {
    Parts(const std::filesystem::path& path, const ReadingOptions& options)
        : deck(options.fluid ? std::optional(deck_of(*options.fluid)) : std::nullopt),
          read(trajectory_to_analyze(path, deck ? &*deck : nullptr, false, options.energies,
                                     {.from = options.from,
                                      .time_step = options.time_step,
                                      .group = options.group,
                                      .positions = positions_of(options.wrapped_positions),
                                      .xyz_comment = options.xyz_comment})) {}

    std::optional<Deck> deck;  ///< what was read points to it
    AnalyzedTrajectory read;
};

Trajectory::Trajectory(const std::filesystem::path& path, const ReadingOptions& options)
    : parts_(std::make_unique<Parts>(path, options)) {}
Trajectory::~Trajectory() = default;
Trajectory::Trajectory(Trajectory&&) noexcept = default;
Trajectory& Trajectory::operator=(Trajectory&&) noexcept = default;

Trajectory::Parts& Trajectory::parts() const {
    if (!parts_) {
        throw InputError("this trajectory has been moved to another one");
    }
    return *parts_;
}

Index Trajectory::frames() const {
    return parts().read.summary.frames;
}

Index Trajectory::atoms() const {
    return parts().read.summary.atoms;
}

Vec3 Trajectory::edges() const {
    return parts().read.summary.edges;
}

bool Trajectory::has_velocities() const {
    return parts().read.summary.has_velocities;
}

const std::vector<double>& Trajectory::times() const {
    return parts().read.summary.times;
}

std::optional<double> Trajectory::spacing() const {
    return parts().read.selection.spacing;
}

const std::vector<std::string>& Trajectory::warnings() const {
    return parts().read.summary.warnings;
}

void Trajectory::each(const std::function<void(const Configuration&)>& take) const {
    each_frame(parts().read, [&](std::size_t /*number*/, Configuration&& frame) { take(frame); });
}

TrajectoryResult Trajectory::analyze(const std::vector<Choice>& analyses) const {
    const AnalyzedTrajectory& read = parts().read;
    std::vector<std::string> names;
    names.reserve(analyses.size());
    for (const Choice& analysis : analyses) {
        names.push_back(analysis.name);
    }
    check_analysis_names(names);
    if (names.empty()) {
        names = default_analyses(read.summary, read.selection);
    }
    return analyze_trajectory(
        read, make_frame_analyses(names, settings_of(analyses), read.deck, read.summary, read.selection));
}

Configuration configuration_in(const std::filesystem::path& path, const ReadingOptions& options) {
    return read_configuration(path, options.fluid ? options.fluid->units : std::nullopt, options.xyz_comment);
}

}  // namespace ljmd
