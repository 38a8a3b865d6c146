#include "run/continuation.hpp"

#include <fmt/format.h>

#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a run is resumed from its newest checkpoint, with its record and the part of each file that was written") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 35);
    const RecordedRun run = recorded_run(deck.directory);
    const auto continuation = find_continuation(run.deck, {"yesterday", {12}, 5});
    REQUIRE(continuation.has_value());
    CHECK(continuation->head.step == 30);
    CHECK(continuation->head.position.stage == 1);
    CHECK(continuation->earlier.began == "yesterday");
    CHECK(continuation->earlier.resumed_at_steps == std::vector<Index>{12, 30});
    CHECK(continuation->earlier.steps_added == 5);
    CHECK(continuation->warnings.empty());
    // A header, and rows at steps 0, 10, 20, 30.
    const std::string written = content_of(deck.directory / "thermo.csv");
    const auto bytes = kept(continuation, &CommittedOutputs::thermo);
    REQUIRE(bytes.has_value());
    CHECK(rows(written.substr(0, static_cast<std::size_t>(*bytes))).size() == 4);
    CHECK_FALSE(kept(std::nullopt, &CommittedOutputs::thermo).has_value());
}

TEST_CASE("checkpoints of another deck, of another version, or without a sound one are refused") {
    const DeckFolder folder;
    Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 35);
    Deck other = deck;
    other.settings.emplace_back("system.density=0.7");
    CHECK_THROWS_AS(find_continuation(other), CheckpointError);
    CHECK_THROWS_WITH(find_continuation(other), Contains("belongs to another deck"));
    for (const std::string& name : checkpoint_names()) {
        if (std::filesystem::exists(deck.directory / name)) {
            std::ofstream(deck.directory / name) << "nonsense";
        }
    }
    CHECK_THROWS_WITH(find_continuation(deck), Contains("no checkpoint can be used") && Contains("not a checkpoint"));
    for (const std::string& name : checkpoint_names()) {
        std::filesystem::remove(deck.directory / name);
    }
    CHECK_FALSE(find_continuation(deck).has_value());
}

TEST_CASE("a checkpoint that no run of its deck can have written is refused, though its checksum is right") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 35);
    const Continuation sound = find_continuation(deck).value();
    REQUIRE(sound.head.position.stage == 1);
    CheckpointHead head = sound.head;
    Archive sound_content = sound.file.content();
    CheckpointHead again;
    sound_content(again);
    std::vector<char> rest(sound_content.left());
    sound_content.numbers(std::span(rest));
    const auto write = [&] {
        CheckpointStore store(deck.directory, 2);
        store.continue_after(sound.file.generation);
        store.write([&](Archive& a) {
            a(head);
            a.numbers(std::span(rest));
        });
    };
    std::string why;
    SECTION("stage") {
        head.position.stage = 2;
        why = "in a stage that the deck does not have";
    }
    SECTION("version of the program") {
        head.version += "x";
        why = fmt::format("was written by ljmd {}; this is {}", head.version, build_info().version);
    }
    SECTION("step of the run") {
        head.step += 1;
        why = "at a step that the deck does not have";
    }
    SECTION("step of the stage") {
        head.position.steps = -1;
        why = "at a step that the deck does not have";
    }
    SECTION("atoms") {
        head.atoms = Index{1} << 40;
        why = "fewer atoms than it says";
    }
    SECTION("box") {
        head.edges[1] = GENERATE(-1.0, 1e-300, 3.9);  // the cutoff is 2
        why = "has a box that the deck cannot have";
    }
    SECTION("outputs") {
        head.outputs.thermo = -1;
        why = "outputs of negative length";
    }
    SECTION("time") {
        head.position.first_time += 0.5;
        write();
        CHECK(find_continuation(deck).has_value());
        CHECK_THROWS_WITH(resume(deck.directory), Contains("its state is at another step or time"));
        return;
    }
    write();
    CHECK_THROWS_AS(find_continuation(deck), CheckpointError);
    CHECK_THROWS_WITH(find_continuation(deck), Contains(why));
}
