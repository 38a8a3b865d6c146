#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <utility>

#include "analyze/evaluated_frame.hpp"
#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"
#include "core/text.hpp"
#include "deck/deck.hpp"
#include "deck/deck_execution.hpp"
#include "deck/deck_system.hpp"
#include "deck/fluid.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "execution/threads.hpp"
#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "io/formats/lammps_dump_writer.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"
#include "run/recorded_run.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd evaluate`.
struct EvaluateOptions {
    std::string path{};                   ///< a configuration, a trajectory, or the directory of a run
    std::string deck{};                   ///< empty: the run's deck, or the options of the potential
    std::vector<std::string> settings{};  ///< arguments of --set, for a deck

    // The potential, where there is no deck.
    std::string potential{};                ///< formula; empty: lennard-jones
    std::vector<std::string> parameters{};  ///< "NAME=VALUE"
    std::string truncation{};
    std::optional<double> cutoff{};        ///< [sigma]
    std::optional<double> switch_start{};  ///< [sigma]
    std::string tail{};                    ///< "true", "false", or empty

    std::optional<Index> frame{};  ///< from 1; none: all
    std::string group{};           ///< particle group of an H5MD file; empty: the only one
    std::string xyz_comment{};     ///< keys missing from the comment lines of an extended XYZ file
    std::string out{};             ///< extended XYZ file or LAMMPS dump to write; empty: none
    int threads = 0;               ///< 0: OMP_NUM_THREADS, or 1
    bool force = false;
    bool json = false;
};

/// How the frames are evaluated.
struct Interacting {
    FluidSpec spec;
    ExecutionOptions execution;
};

PairPotential::Parameters parameters_of(const EvaluateOptions& options) {
    PairPotential::Parameters parameters;
    for (const std::string& text : options.parameters) {
        const std::size_t equals = text.find('=');
        const auto value = equals == std::string::npos ? std::nullopt : to_number(text.substr(equals + 1));
        if (!value) {
            throw InputError(fmt::format(
                "--parameter: {} is not allowed: NAME=VALUE, the value a number in reduced units", in_quotes(text)));
        }
        parameters.emplace_back(text.substr(0, equals), *value);
    }
    return parameters;
}

Interacting of_options(const EvaluateOptions& options) {
    if (!options.settings.empty()) {
        throw InputError("--set changes a deck: give one with --deck, or the potential with --cutoff and --truncation");
    }
    std::vector<std::string> missing;
    if (!options.cutoff) {
        missing.emplace_back("--cutoff");
    }
    if (options.truncation.empty()) {
        missing.emplace_back("--truncation");
    }
    if (options.tail.empty() && PairPotential::takes_tail(options.truncation)) {
        missing.emplace_back("--tail");
    }
    if (PairPotential::takes_switch_start(options.truncation) && !options.switch_start) {
        missing.emplace_back("--switch-start");
    }
    if (!missing.empty()) {
        throw InputError(fmt::format("the potential is not known: give {}, or a --deck", fmt::join(missing, ", ")));
    }
    if (options.switch_start && !PairPotential::takes_switch_start(options.truncation)) {
        throw InputError(
            fmt::format("--switch-start has no meaning for --truncation {}: only for switched", options.truncation));
    }
    const Cutoff cutoff{.radius = *options.cutoff, .switch_start = options.switch_start.value_or(0.0)};
    const bool tail = options.tail == "true";
    for (const Mistake& mistake : potential_mistakes(options.truncation, cutoff, tail)) {
        throw InputError(in_words(mistake));
    }
    FluidSpec spec;
    spec.potential = PairPotential::make(options.potential.empty() ? "lennard-jones" : options.potential,
                                         options.truncation, cutoff, parameters_of(options));
    spec.tail = tail;
    return {std::move(spec), {.threads = options.threads > 0 ? options.threads : default_thread_count()}};
}

void refuse_potential_options(const EvaluateOptions& options) {
    if (options.cutoff || options.switch_start || !options.truncation.empty() || !options.tail.empty() ||
        !options.potential.empty() || !options.parameters.empty()) {
        throw InputError(
            "the potential is that of the deck: change it with --set, as in --set potential.cutoff=3.0, or leave "
            "out "
            "the "
            "deck");
    }
}

/// The deck that is asked for, or of the run; nothing if there is none.
std::optional<Deck> deck_of(const EvaluateOptions& options, bool is_run) {
    if (options.deck.empty() && !is_run) {
        return std::nullopt;
    }
    refuse_potential_options(options);
    Diagnostics diagnostics;
    std::optional<Deck> deck = options.deck.empty() ? recorded_deck(options.path, options.settings, diagnostics)
                                                    : load_deck(options.deck, options.settings, true, diagnostics);
    diagnostics.throw_if_errors();
    require_fluid(*deck, fmt::format("{} is about few bodies, which have no box and no pair potential",
                                     options.deck.empty() ? options.path : options.deck));
    if (!deck->given.external.empty()) {
        warn(
            fmt::format("the external force {} of the run's program is not known here: energies and forces are those "
                        "of the pairs alone",
                        in_quotes(deck->given.external)));
    }
    return deck;
}

bool is_dump(const fs::path& path) {
    return path.extension() == ".lammpsdump" || path.extension() == ".dump";
}

/// Refuse a file that must not be written. @return none if none is asked for
std::optional<fs::path> frames_to_write(const EvaluateOptions& options) {
    if (options.out.empty()) {
        return std::nullopt;
    }
    const fs::path path(options.out);
    if (path.extension() != ".xyz" && path.extension() != ".extxyz" && !is_dump(path)) {
        throw InputError(
            fmt::format("--out: {} is not allowed: the name ends in .xyz for extended XYZ, or in "
                        ".lammpsdump for a dump of LAMMPS",
                        in_quotes(options.out)));
    }
    require_no_run(path.has_parent_path() ? path.parent_path() : fs::path("."), "Nothing was written");
    require_writable(path, {.force = options.force});
    return path;
}

void write_frame(OutputFile& file, const EvaluatedFrame& frame, bool as_dump, const std::string& source) {
    const FrameContents contents{
        .velocities = frame.has_velocities, .forces = true, .energies = frame.energies, .source = frame.source};
    if (!as_dump) {
        write_extended_xyz_frame(file, frame.state, contents, std::nullopt);
        return;
    }
    if (!frame.source.step) {
        throw InputError(
            fmt::format("--out: every frame of a dump of LAMMPS has a step, and those of {} have none: write extended "
                        "XYZ, to a name that ends in .xyz",
                        source));
    }
    write_lammps_dump_frame(file, frame.state, contents);
}

/// Prints what was found: one frame in full, several as a table.
class Printer {
  public:
    Printer(const FluidSpec& spec, std::string source, bool json)
        : spec_(spec), source_(std::move(source)), json_(json) {}

    void add(EvaluatedFrame frame) {
        if (first_) {
            print_result(json_
                             ? "{\"frames\": [\n"
                             : fmt::format("{}: {} atoms, box {:.6g} x {:.6g} x {:.6g} sigma^3\n{}\n\n{}", source_,
                                           first_->state.count(), first_->state.box().edges()[0],
                                           first_->state.box().edges()[1], first_->state.box().edges()[2],
                                           wrapped(interaction_in_words(spec_), screen_columns, 2), frame_headings()));
            print_one(*first_);
            first_.reset();
            several_ = true;
        }
        if (several_) {
            print_one(frame);
        } else {
            first_.emplace(std::move(frame));
        }
    }

    void finish() {
        if (first_) {
            print_document(frame_document(*first_, spec_, source_), json_);
        } else if (json_) {
            print_result("\n]}\n");
        } else {
            print_result(has_velocities_ ? "" : "\npressure: the virial part alone where a frame has no velocities\n");
            print_result(too_near_.empty() ? "" : fmt::format("\n{}\n", wrapped(too_near_, screen_columns, 0)));
        }
    }

  private:
    void print_one(const EvaluatedFrame& frame) {
        has_velocities_ = has_velocities_ && frame.has_velocities;
        if (too_near_.empty() && !frame.too_near.empty()) {
            too_near_ = fmt::format("in frame {}, and maybe in later ones: {}", frame.number, frame.too_near);
        }
        if (json_) {
            print_result((printed_ > 0 ? ",\n" : "") + to_json(frame_document(frame, spec_, source_).data));
        } else {
            print_result(frame_row(frame));
        }
        ++printed_;
    }

    const FluidSpec& spec_;
    std::string source_;
    bool json_;
    bool several_ = false;
    bool has_velocities_ = true;
    std::string too_near_;  ///< of the first frame that has such pairs
    Index printed_ = 0;
    std::optional<EvaluatedFrame> first_;  ///< held back until it is known whether there are more
};

class EvaluateCommand : public Command {
  public:
    EvaluateCommand()
        : Command("evaluate", Part::results, "energy, virial, pressure and forces of a configuration; nothing is run") {
    }

    void add_options(CLI::App& command) override {
        command
            .add_option(
                "configuration", options_.path,
                "configuration or trajectory in any format that is read, or directory of a run, whose final.xyz is "
                "taken")
            ->required()
            ->type_name("CONFIGURATION");
        command.add_option("--deck", options_.deck, "deck with the potential, and [argon] for files in SI units")
            ->type_name("DECK");
        command.add_option("--set", options_.settings, "replace a value of the deck, e.g. --set potential.cutoff=3.0")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        add_potential_options(command);
        command.add_option("--frame", options_.frame, "one frame of a trajectory, counted from 1; all by default")
            ->type_name("K")
            ->check(CLI::PositiveNumber);
        command
            .add_option("--group", options_.group, "of an H5MD file with several groups of particles, the one to take")
            ->type_name("NAME");
        command
            .add_option("--xyz-comment", options_.xyz_comment,
                        "what the comment lines of an XYZ file lack, e.g. 'Lattice=\"20 0 0 0 20 0 0 0 20\"'")
            ->type_name("KEY=VALUE...");
        command
            .add_option("--out", options_.out,
                        "file to write, with forces and energies of the atoms: *.xyz, or *.lammpsdump")
            ->type_name("FILE");
        add_threads(command, options_.threads);
        command.add_flag("--force", options_.force, "replace the file if it exists");
        command.add_flag("--json", options_.json, "print the result as JSON, with forces and energies of all atoms");
    }

    void run() override {
        const bool is_run = input_is_directory(options_.path);
        const std::optional<Deck> deck = deck_of(options_, is_run);
        const Interacting how =
            deck ? Interacting{fluid_spec(*deck), execution_options(*deck, options_.threads)} : of_options(options_);
        const Execution execution(how.execution);
        const fs::path path = configuration_file(options_.path);
        const std::optional<fs::path> written = frames_to_write(options_);
        const auto reader =
            open_frames(path, deck ? deck->units() : std::nullopt, options_.group, options_.xyz_comment);

        const auto evaluate_all = [&](OutputFile* file) {
            Printer printer(how.spec, path.string(), options_.json);
            Index evaluated = 0;
            Index number = 0;
            for (Frame frame; reader->next(frame); frame = {}) {
                ++number;
                if (options_.frame && number != *options_.frame) {
                    continue;
                }
                EvaluatedFrame found = evaluate_frame(std::move(frame), number, how.spec, execution, path.string());
                if (file != nullptr) {
                    write_frame(*file, found, is_dump(*written), path.string());
                }
                printer.add(std::move(found));
                ++evaluated;
                if (options_.frame) {
                    break;
                }
            }
            if (evaluated == 0) {
                throw DataError(options_.frame ? fmt::format("{} has {} frame{}, no frame {}", path.string(), number,
                                                             number == 1 ? "" : "s", *options_.frame)
                                               : fmt::format("{} has no frame", path.string()));
            }
            printer.finish();
        };
        if (written) {
            write_output(*written, {.force = options_.force}, [&](OutputFile& file) { evaluate_all(&file); });
        } else {
            evaluate_all(nullptr);
        }
        for (const std::string& text : reader->warnings()) {
            warn(text);
        }
    }

  private:
    void add_potential_options(CLI::App& command) {
        command.add_option("--cutoff", options_.cutoff, "without a deck: pairs closer than this interact, in sigma")
            ->type_name("RC")
            ->check(reduced("sigma", Dimension::length));
        command.add_option("--truncation", options_.truncation, "without a deck: what happens at the cutoff")
            ->type_name("HOW")
            ->check(CLI::IsMember(PairPotential::truncation_names()));
        command
            .add_option("--tail", options_.tail,
                        "without a deck: true or false, correct for what cut and switched leave out")
            ->type_name("BOOL")
            ->check(CLI::IsMember({"true", "false"}));
        command.add_option("--switch-start", options_.switch_start, "without a deck: where switched begins, in sigma")
            ->type_name("R")
            ->check(reduced("sigma", Dimension::length));
        command.add_option("--potential", options_.potential, "without a deck: lennard-jones by default")
            ->type_name("TYPE")
            ->check(CLI::IsMember(PairPotential::formula_names()));
        command
            .add_option("--parameter", options_.parameters, "without a deck: one of the potential's, in reduced units")
            ->type_name("NAME=VALUE")
            ->allow_extra_args(false);
    }

    EvaluateOptions options_;
};

}  // namespace

std::shared_ptr<Command> evaluate_command() {
    return std::make_shared<EvaluateCommand>();
}

}  // namespace ljmd
