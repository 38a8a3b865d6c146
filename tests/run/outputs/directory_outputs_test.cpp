#include "run/outputs/directory_outputs.hpp"

#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// Measures nothing.
struct Idle : RunMeasurement {
    void resume_at(const LoopPosition& /*position*/) override {}
    void archive(Archive& /*a*/) override {}
    void require_begun(const LoopPosition& /*position*/) const override {}
    [[nodiscard]] bool wants_energy(Index /*step*/) const override { return false; }
    void step_done(const Stage& /*stage*/, const Evaluation& /*evaluation*/) override {}
    [[nodiscard]] bool wants_checkpoint(bool /*last_of_stage*/) override { return false; }
    void checkpoint(const LoopPosition& /*position*/) override {}
};

}  // namespace

TEST_CASE("files are there once the run begins, and not before") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    prepare_directory(deck.directory);
    FluidSystem fluid = simulation_of(deck);
    Recorder listener;
    const RunControl control;
    DirectoryOutputs outputs(deck, listener, control);
    CHECK(std::filesystem::is_empty(deck.directory));
    Idle measurement;
    const auto from = restored(deck, control.continuation, measurement, fluid.state);
    CHECK_FALSE(from);
    CHECK(std::filesystem::is_empty(deck.directory));
    outputs.begin(fluid, from);
    CHECK(std::filesystem::exists(deck.directory / "run.json"));

    outputs.stage_begins(deck.stages()[1]);
    outputs.step_done(3);
    CHECK(listener.stages == std::vector<std::string>{"production"});
    CHECK(listener.steps == std::vector<Index>{3});
    CHECK(outputs.checkpoint_is_due(3, true));
    outputs.checkpoint(fluid.state, {}, [&fluid](Archive& a) { a(fluid.state); });
    CHECK(find_continuation(deck));
}
