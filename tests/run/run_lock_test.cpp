#include "run/run_lock.hpp"

#include "deck/deck_fixtures.hpp"
#include "io/files/replacement_file.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

TEST_CASE("a new run gets a directory that is made, locked and its own, wherever it is moved to") {
    const DeckFolder folder;
    Deck deck = folder.load();
    std::vector<std::string> warnings;
    const auto keep = [&warnings](const std::string& text) { warnings.push_back(text); };
    RunLock lock(deck, false, keep);
    CHECK_THROWS_AS(RunLock(deck.directory, keep), InUseError);
    fs::rename(deck.directory, folder / "moved");
    fs::create_directory(deck.directory);
    write_file_atomically(deck.outputs() / "run.json", "new");
    CHECK(content_of(folder / "moved/run.json") == "new");
    CHECK(fs::is_empty(deck.directory));
    lock.has_begun();
    CHECK(warnings.empty());
    lock.warn_if_moved();
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains(deck.directory.string() + " was moved or replaced"));
}

TEST_CASE("an earlier run is replaced by force alone, and not before the new one has begun") {
    const DeckFolder folder;
    Deck deck = folder.load();
    fs::create_directory(deck.directory);
    std::ofstream(deck.directory / "run.json") << "old";
    const auto keep = [](const std::string& text) { FAIL("not expected: " + text); };
    CHECK_THROWS_AS(RunLock(deck, false, keep), InputError);
    {
        const RunLock lock(deck, true, keep);
        CHECK_FALSE(fs::exists(deck.directory / "run.json"));
    }
    CHECK(content_of(deck.directory / "run.json") == "old");
    deck.locked.reset();  // it shares the lock
    RunLock lock(deck, true, keep);
    lock.has_begun();
    CHECK(fs::is_empty(deck.directory));
}

TEST_CASE("what could not be removed of an earlier run is removed at the end") {
    const DeckFolder folder;
    Deck deck = folder.load();
    fs::create_directory(deck.directory);
    std::ofstream(deck.directory / "run.json") << "old";
    {
        RunLock lock(deck, true, [](const std::string& text) { FAIL("not expected: " + text); });
        fs::create_directory(deck.directory / ".ljmd-earlier/failed.xyz");  // a file that cannot be removed now
        lock.has_begun();
        fs::remove(deck.directory / ".ljmd-replaced/failed.xyz");
        REQUIRE(fs::exists(deck.directory / ".ljmd-replaced"));
    }
    CHECK(fs::is_empty(deck.directory));
}
