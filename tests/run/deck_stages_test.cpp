#include "ljmd/run/deck_stages.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/run/run_directory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// Forces that cannot be computed after the start.
class Breaking : public ForceField {
    Evaluation compute(State& state, Request) override {
        if (started_) {
            throw PhysicsError("a spring broke");
        }
        started_ = true;
        state.write_forces().setZero();
        return {};
    }

    bool started_ = false;
};

struct Nobody : StepObserver {
    void started(const Evaluation&) override {}
    void stage_begins(const Stage&) override {}
    [[nodiscard]] bool wants_energy(Index) const override { return false; }
    void moved(Index) override {}
    void step_done(const Stage&, const Evaluation&) override {}
    void stage_ends(const Stage&) override {}
};

}  // namespace

TEST_CASE("a run of a deck that fails leaves its configuration, and says where") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load();
    prepare_directory(deck.directory);
    State state(2);
    Breaking force_field;
    Nobody observer;
    const std::string file = (deck.directory / "failed.xyz").string();
    CHECK_THROWS_WITH(run_stages(deck, state, force_field, observer),
                      Contains("step 1 (stage ") && Contains("a spring broke") && Contains(file));
    CHECK(std::filesystem::exists(file));
}
