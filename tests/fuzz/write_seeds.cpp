// Writes those seeds of the corpora that only the program can make: checkpoints and trajectories.
//
//     fuzz_write_seeds CORPORA      writes CORPORA/<target>/...

#include <fmt/format.h>

#include <functional>

#include "deck/deck_execution.hpp"
#include "deck/deck_system.hpp"
#include "fuzzed_decks.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "resumed_run.hpp"
#include "run/run.hpp"
#include "two_atoms.hpp"

using namespace ljmd;

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, std::span<const std::byte> bytes) {
    write_file_atomically(path, fuzz::text_of(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

/// What ends a run at a step.
struct Stopped {};

struct StopAt : RunListener {
    explicit StopAt(Index step) : step_(step) {}
    void step_done(Index step) override {
        if (step == step_) {
            throw Stopped();
        }
    }

  private:
    Index step_;
};

void run(const Deck& deck, RunListener& listener) {
    const bool fluid = kind_name(deck) == "fluid";
    AnySystem system = make_system(deck, fluid ? std::optional(find_start(deck)) : std::nullopt,
                                   Execution(execution_options(deck)), [](const std::string&) {});
    static_cast<void>(run_plan(deck, system, listener));
}

/// The contents of the checkpoints that the run of a deck writes: at its start, on its way, at the end of a stage.
void write_checkpoints(const fuzz::FuzzedDeck& fuzzed, const fs::path& corpora, const std::string& target,
                       const std::string& name) {
    const fuzz::RunFolder folder(fuzzed);
    const Deck& deck = folder.deck();
    const Index stage = deck.stages().front().steps;
    for (const Index step : {Index{1}, stage, stage + 1, total_steps(deck.stages())}) {
        prepare_directory(deck.directory);
        StopAt listener(step);
        try {
            run(deck, listener);
        } catch (const Stopped&) {
        }
        const auto point = find_continuation(deck);
        std::vector<char> content(point->file.length);
        point->file.content().numbers(std::span(content));
        write(corpora / target / fmt::format("{}-after-{}", name, point->head.step), std::as_bytes(std::span(content)));
        if (step == stage) {
            fs::copy_file(point->file.path, corpora / "checkpoint_file" / name, fs::copy_options::overwrite_existing);
        }
    }
}

/// Two frames of two atoms: the file, and what a checkpoint knows of it in front.
void write_trajectory(const fs::path& corpus) {
    const test::WrittenFile file("");
    State state = fuzz::two_atoms();
    const auto writer = make_trajectory_writer("h5md", state, {.path = file.path(), .velocities = true});
    writer->write(state);
    writer->write(state);
    CommittedFrames frames = writer->commit();
    writer->close();
    Archive places;
    places(frames);
    std::ifstream written(file.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(written), std::istreambuf_iterator<char>()};
    const auto first = std::as_bytes(std::span(bytes));
    std::vector<std::byte> all(places.bytes().begin(), places.bytes().end());
    all.insert(all.end(), first.begin(), first.end());
    write(corpus / "trajectory", first);
    write(corpus / "two-frames", all);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s CORPORA\n", argv[0]);
        return 2;
    }
    const fs::path corpora = argv[1];
    for (const char* target : {"checkpoint_file", "checkpoint_fluid", "checkpoint_few_body", "h5md"}) {
        fs::create_directories(corpora / target);
    }
    write_checkpoints(fuzz::fluid, corpora, "checkpoint_fluid", "fluid");
    write_checkpoints(fuzz::constant_pressure, corpora, "checkpoint_fluid", "constant-pressure");
    write_checkpoints(fuzz::orbit, corpora, "checkpoint_few_body", "orbit");
    write_checkpoints(fuzz::radial, corpora, "checkpoint_few_body", "radial");
    write_trajectory(corpora / "h5md");
}
