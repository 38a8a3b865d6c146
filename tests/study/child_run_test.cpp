#include "study/child_run.hpp"

#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <optional>

#include "deck/fluid.hpp"
#include "io/files/claimed_file.hpp"
#include "io/files/directory_lock.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

// That the jobs do what they say is tried by the tests in tests/cli, which run the program.

namespace {

const std::vector<std::string> hot{"system.temperature=1.5"};

ChildRun run_in(const DeckFolder& folder, const std::vector<std::string>& settings = hot) {
    return {.name = "hot",
            .deck = folder.deck_path(),
            .source = small_deck,
            .settings = settings,
            .directory = folder / "out",
            .log = folder / "hot.log"};
}

/// The verb and the directory of a job.
std::pair<std::string, std::string> verb(const std::optional<Job>& job) {
    REQUIRE(job.has_value());
    const auto& words = job->arguments;
    return {words[0], words[0] == "run" ? words[3] : words[1]};
}

}  // namespace

TEST_CASE("a run begins, is resumed, and is left alone when it is finished") {
    const DeckFolder folder;
    const ChildRun run = run_in(folder);
    const auto first = next_job(run);
    CHECK(verb(first) == std::pair(std::string("run"), run.directory.string()));
    CHECK(first->arguments == std::vector<std::string>{"run", run.deck, "--out", run.directory, "--quiet", "--force",
                                                       "--threads", "1", "--set", hot[0]});
    CHECK(first->output == run.log);

    run_until(folder.load(hot), 30);  // a checkpoint lies at the end of the first stage
    CHECK_FALSE(holds_another_run(run));
    CHECK(verb(next_job(run)) == std::pair(std::string("resume"), run.directory.string()));

    fs::remove(run.directory / "checkpoint.1");
    fs::remove(run.directory / "checkpoint.2");
    CHECK(verb(next_job(run)).first == "run");

    const Deck deck = folder.load(hot);
    FluidSystem simulation = simulation_of(deck);
    prepare_directory(deck.directory);
    Recorder listener;
    static_cast<void>(run_plan(deck, simulation, listener));
    CHECK_FALSE(next_job(run).has_value());
    CHECK(longer(run, 60).arguments == std::vector<std::string>{"resume", run.directory, "--quiet", "--steps", "+60"});
}

TEST_CASE("a run of another deck or with other settings is another one, and not replaced until it is forgotten") {
    const DeckFolder folder;
    run_until(folder.load(hot), 30);
    const ChildRun run = run_in(folder);
    ChildRun other_deck = run;
    other_deck.source += "\n";
    for (const ChildRun& other : {run_in(folder, {}), run_in(folder, {"system.temperature=1.50"}), other_deck}) {
        CHECK(holds_another_run(other));
        CHECK_THROWS_WITH(next_job(other), EndsWith("of another deck or with other settings. It was left as it is"));
    }
    forget_another_run(run);
    CHECK_NOTHROW(next_job(run));
    CHECK(verb(next_job(run)).first == "resume");
    forget_another_run(run_in(folder, {}));
    CHECK(verb(next_job(run_in(folder, {}))).first == "run");
    std::ofstream(run.directory / "run.json") << "{";
    CHECK_FALSE(holds_another_run(run));  // not known to be another
    CHECK_THROWS_AS(next_job(run), DataError);
    forget_another_run(run);
    CHECK(verb(next_job(run)).first == "run");
}

TEST_CASE("a run does not begin from a deck that was changed since it was prepared") {
    const DeckFolder folder;
    const ChildRun run = run_in(folder);
    std::ofstream(run.deck, std::ios::app) << "\n# later\n";
    CHECK_THROWS_WITH(next_job(run), StartsWith(run.deck.string() + " is not the deck that was prepared"));
}

TEST_CASE("a failure is told by the last error in the log, or its last line, as a terminal may show it") {
    const DeckFolder folder;
    const ChildRun run = run_in(folder);
    CHECK(failure_of(run, 137) == "hot: exit code 137 (signal 9): " + run.log.string() + ": no such file");
    std::ofstream(run.log) << "warning: x\nkilled \x1B[31m\n\n";
    CHECK(failure_of(run, 137) == "hot: exit code 137 (signal 9): killed ?[31m");
    std::ofstream(run.log) << "";
    CHECK(failure_of(run, 139) == "hot: exit code 139 (signal 11)");
    std::ofstream(run.log) << "error: a\nerror: blown up\n  the configuration is in failed.xyz\n";
    CHECK(failure_of(run, 5) == "hot: exit code 5: error: blown up");
    CHECK(recorded_failure(run.log) == "error: blown up");
    std::ofstream(run.log) << "stopped after step 3\n";
    CHECK(recorded_failure(run.log).empty());
    CHECK(recorded_failure(folder / "no log").empty());
}

TEST_CASE("how a run has failed is noted in its log, unless it was stopped with a checkpoint") {
    const DeckFolder folder;
    const ChildRun run = run_in(folder);
    const auto log = ClaimedFile::claim(run.log);
    REQUIRE(log.has_value());
    log->append("error: blown up\n");
    for (const int stopped : {0, 75, 128 + SIGTERM, 128 + SIGINT, 128 + SIGUSR1}) {
        record_end(*log, stopped);
        CHECK(recorded_failure(run.log) == "error: blown up");
    }
    record_end(*log, 5);
    CHECK(recorded_failure(run.log) == "exit code 5: error: blown up");
    CHECK(failure_of(run, 5) == "hot: exit code 5: error: blown up");
    log->clear();
    record_end(*log, 137);
    CHECK(recorded_failure(run.log) == "exit code 137 (signal 9)");
}

TEST_CASE("places that lead elsewhere are refused") {
    const DeckFolder folder;
    const ChildRun run = run_in(folder);
    CHECK_NOTHROW(check_places(run));
    std::ofstream(run.log) << "error: of an earlier time\n";
    CHECK_NOTHROW(check_places(run));
    fs::remove(run.log);
    fs::create_symlink(folder / "precious", run.log);
    CHECK_THROWS_AS(check_places(run), InputError);
    fs::remove(run.log);
    REQUIRE(mkfifo(run.log.c_str(), 0600) == 0);
    CHECK_THROWS_WITH(check_places(run), Catch::Matchers::Contains("hot.log is in the way"));
    CHECK(failure_of(run, 5) == "hot: exit code 5: " + run.log.string() + ": is a pipe, not a regular file");
    fs::remove(run.log);
    fs::create_directory(folder / "elsewhere");
    fs::create_directory_symlink(folder / "elsewhere", run.directory);
    CHECK_THROWS_WITH(check_places(run), Catch::Matchers::Contains(run.directory.string() + " is in the way"));
    fs::remove(run.directory);
    fs::create_directory(run.directory);
    CHECK_NOTHROW(check_places(run));
}

TEST_CASE("runs that still write into a folder are waited for") {
    const DeckFolder folder;
    fs::create_directories(folder / "runs/free");
    fs::create_directories(folder / "runs/held");
    std::ofstream(folder / "runs/file") << "text";
    std::vector<std::string> told;
    std::optional<DirectoryLock> lock;
    const auto tell = [&](const std::string& text) {
        told.push_back(text);
        lock.reset();
    };
    wait_for_runs(folder / "runs/absent", Interruption(), tell);
    lock.emplace(folder / "runs/held");
    wait_for_runs(folder / "runs", Interruption(), tell);
    CHECK_FALSE(lock.has_value());
    CHECK(told == std::vector<std::string>{"waiting for the run that is still writing to " +
                                           (folder / "runs/held").string() + "\n"});
    wait_for_runs(folder / "runs", Interruption(), tell);
    lock.emplace(folder / "runs/held");
    const Interruption stopped(std::nullopt, [] { return std::optional(StopRequest{15, "SIGTERM"}); });
    CHECK_THROWS_AS(wait_for_runs(folder / "runs", stopped, tell), Interrupted);
}
