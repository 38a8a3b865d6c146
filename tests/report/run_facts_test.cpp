#include "report/run_facts.hpp"

#include "io/files/directory_lock.hpp"
#include "io/files/input_file.hpp"
#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a run is finished, stopped or failed, and its page tells title, deck and program") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_until(deck, 30);
    CHECK(run_facts(deck.directory).state == "stopped");
    CHECK_THAT(run_facts(deck.directory).state_words, Contains("step 20 of 60"));
    overwrite(deck.directory / "failed.xyz", "");
    CHECK(run_facts(deck.directory).state == "failed");
    std::filesystem::remove(deck.directory / "failed.xyz");

    run_whole(deck);
    const RunFacts facts = run_facts(deck.directory);
    CHECK(facts.state == "finished");
    CHECK(facts.problems.empty());
    const PageContent page = page_of(facts);
    CHECK(page.kind == "run");
    CHECK(page.title == deck.title);
    CHECK(page.source == deck.directory.string());
    const auto text_called = [](const TextPairs& pairs, const std::string& key) {
        const auto found = std::ranges::find(pairs, key, &TextPairs::value_type::first);
        return found == pairs.end() ? std::string() : found->second;
    };
    CHECK(text_called(page.downloads, "deck") == deck.source);
    CHECK_THAT(text_called(page.downloads, "bibtex"), Contains("10.1103/PhysRev.159.98"));
    CHECK(text_called(page.program, "program") == "ljmd");
    CHECK_FALSE(text_called(page.provenance, "hash of the deck").empty());
}

TEST_CASE("a run whose directory is held is running") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_until(deck, 30);
    const DirectoryLock lock(deck.directory);
    CHECK(run_facts(deck.directory).state == "running");
}

TEST_CASE("what is damaged is named, and the rest is read") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_whole(deck);
    overwrite(deck.directory / "results.json", "{");
    const RunFacts facts = run_facts(deck.directory);
    CHECK(facts.state == "damaged");
    CHECK(facts.run.has_value());
    CHECK(facts.results.is_null());
    REQUIRE(facts.problems.size() == 1);
    CHECK_THAT(facts.problems[0], Contains("results.json"));

    overwrite(deck.directory / "run.json", "{\"program\": \"ljmd\", \"kind\": \"fluid\", \"finished\": true}");
    CHECK_FALSE(run_facts(deck.directory).run.has_value());
    overwrite(deck.directory / "run.json", "{\"program\": \"lammps\"}");
    CHECK_THROWS_WITH(run_facts(deck.directory), Contains("is not the record of a run of ljmd"));
    std::filesystem::remove(deck.directory / "run.json");
    CHECK_THROWS_WITH(run_facts(deck.directory), Contains("has no run.json"));
}

TEST_CASE("the record of an older version, which lacks what came later, is read") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_whole(deck);
    std::string record = read_input(deck.directory / "run.json");
    const std::size_t at = record.find("  \"given\": null,\n");
    REQUIRE(at != std::string::npos);
    record.erase(at, std::string("  \"given\": null,\n").size());
    overwrite(deck.directory / "run.json", record);
    const RunFacts facts = run_facts(deck.directory);
    CHECK(facts.state == "finished");
    CHECK(facts.problems.empty());
}
