#include "run/outputs/shared_outputs.hpp"

#include <mutex>
#include "catch.hpp"

#include "execution/rank_team.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using test::DeckFolder;
using test::RankTeam;

namespace {

/// Outputs that want a checkpoint at step 3, and stop the run at step 5.
class Stopping : public RunOutputs {
  public:
    [[nodiscard]] bool checkpoint_is_due(Index step, bool /*last_of_stage*/) override {
        step_ = step;
        return step == 3 || step == 5;
    }
    void checkpoint(const State& /*state*/, const LoopPosition& /*position*/,
                    const std::function<void(Archive&)>& archive) override {
        Archive a;
        archive(a);
        if (step_ == 5) {
            throw Interrupted("stopped", 143);
        }
    }

  private:
    Index step_ = 0;
};

}  // namespace

TEST_CASE("rank 0 decides for all when a checkpoint is written and the run is stopped") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const int size = GENERATE(1, 3);
    std::mutex mutex;
    std::vector<std::string> heard;
    RankTeam(size).run([&](std::shared_ptr<Ranks> ranks) {
        Stopping stopping;
        SharedOutputs outputs(deck, *ranks, ranks->is_root() ? &stopping : nullptr);
        const State state(1);
        std::string text;
        try {
            for (Index step = 1; step < 10; ++step) {
                if (outputs.checkpoint_is_due(step, false)) {
                    outputs.checkpoint(state, {}, [&](Archive&) { text += std::to_string(step) + " "; });
                }
            }
        } catch (const Interrupted& stop) {
            text += "stopped with " + std::to_string(stop.exit_code());
        }
        const std::lock_guard lock(mutex);
        heard.push_back(text);
    });
    CHECK(heard == std::vector<std::string>(static_cast<std::size_t>(size), "3 5 stopped with 143"));
}
