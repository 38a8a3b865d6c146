#include "study/job_pool.hpp"

#include <fmt/format.h>

#include <map>
#include "catch.hpp"

#include "io/files/claimed_file.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
namespace fs = std::filesystem;

namespace {

Job shell(const TemporaryFolder& folder, const std::string& name, const std::string& script) {
    return {{"-c", script}, folder / name};
}

/// Run lines whose first jobs are these.
void run_these(const fs::path& program, const std::vector<Job>& jobs, int at_most, const NextJob& next,
               const Interruption& interruption = Interruption()) {
    run_jobs(
        program, jobs.size(), at_most, [&jobs](std::size_t line) { return std::optional(jobs[line]); }, next,
        interruption);
}

}  // namespace

TEST_CASE("lines of jobs run to their ends, each job after the one before it") {
    const TemporaryFolder folder;
    const std::string log = (folder / "log").string();
    std::vector<Job> first;
    for (int line = 0; line < 5; ++line) {
        first.push_back(
            shell(folder, fmt::format("out{}", line), fmt::format("echo {}0 >> {}; exit {}", line, log, line)));
    }
    std::map<std::size_t, std::vector<int>> statuses;
    run_these("/bin/sh", first, 2, [&](std::size_t line, int status) -> std::optional<Job> {
        statuses[line].push_back(status);
        if (statuses[line].size() < 3) {
            return shell(folder, "more", fmt::format("echo {}{} >> {}; exit 7", line, statuses[line].size(), log));
        }
        return std::nullopt;
    });
    REQUIRE(statuses.size() == 5);
    const std::string text = content_of(log);
    for (int line = 0; line < 5; ++line) {
        CHECK(statuses[static_cast<std::size_t>(line)] == std::vector<int>{line, 7, 7});
        CHECK(text.find(fmt::format("{}0\n", line)) < text.find(fmt::format("{}1\n", line)));
        CHECK(text.find(fmt::format("{}1\n", line)) < text.find(fmt::format("{}2\n", line)));
    }
}

TEST_CASE("as many jobs run at a time as are allowed, not more") {
    for (const int at_most : {1, 3}) {
        const TemporaryFolder folder;
        // Each job counts those that run with it.
        const std::string script =
            fmt::format("touch {0}/here.$$; ls {0} | grep -c here >> {0}/counts; sleep 0.3; rm {0}/here.$$",
                        (folder / "").string());
        const std::vector<Job> jobs(6, shell(folder, "out", script));
        run_these("/bin/sh", jobs, at_most, [](std::size_t, int) { return std::nullopt; });
        std::ifstream counts(folder / "counts");
        int most = 0;
        for (int count = 0; counts >> count;) {
            most = std::max(most, count);
        }
        CHECK(most == at_most);
    }
}

TEST_CASE("no jobs are done at once") {
    run_these("/bin/sh", {}, 2,
              [](std::size_t, int) -> std::optional<Job> { throw ContractViolation("none has ended"); });
}

TEST_CASE("what a job says lies in its file, and a program that is not there is an error") {
    const TemporaryFolder folder;
    run_these("/bin/sh", {shell(folder, "said", "echo yes")}, 1, [](std::size_t, int) { return std::nullopt; });
    CHECK(content_of(folder / "said") == "yes\n");
    CHECK_THROWS_AS(
        run_these(folder / "no-program", {Job{{}, folder / "said"}}, 1, [](std::size_t, int) { return std::nullopt; }),
        FileError);
}

TEST_CASE("when a step after a job fails, no job is left behind") {
    const TemporaryFolder folder;
    const std::string late = (folder / "late").string();
    const std::vector<Job> jobs{shell(folder, "a", "exit 0"), shell(folder, "b", "sleep 5; touch " + late)};
    CHECK_THROWS_AS(
        run_these("/bin/sh", jobs, 2, [](std::size_t, int) -> std::optional<Job> { throw DataError("bad"); }),
        DataError);
    CHECK_FALSE(fs::exists(late));
}

TEST_CASE("the first job of a line is asked for when its turn has come, and a line may have none") {
    const TemporaryFolder folder;
    std::vector<std::string> order;
    run_jobs(
        "/bin/sh", 3, 1,
        [&](std::size_t line) -> std::optional<Job> {
            order.push_back(fmt::format("first {}", line));
            return line == 1 ? std::nullopt : std::optional(shell(folder, "out", "exit 0"));
        },
        [&](std::size_t line, int) -> std::optional<Job> {
            order.push_back(fmt::format("ended {}", line));
            return std::nullopt;
        });
    CHECK(order == std::vector<std::string>{"first 0", "ended 0", "first 1", "first 2", "ended 2"});
}

TEST_CASE("at the end of the wall time all jobs are asked to stop, and no other is begun") {
    const TemporaryFolder folder;
    const std::string wait = "trap 'echo asked; exit 3' USR1; while :; do sleep 0.01; done";
    const std::vector<Job> jobs{shell(folder, "a", wait), shell(folder, "b", "echo begun")};
    int ended = 0;
    CHECK_THROWS_AS(run_these(
                        "/bin/sh", jobs, 1,
                        [&](std::size_t, int) -> std::optional<Job> {
                            ++ended;
                            return std::nullopt;
                        },
                        Interruption(1.0)),
                    Interrupted);
    CHECK(content_of(folder / "a") == "asked\n");
    CHECK_FALSE(fs::exists(folder / "b"));
    CHECK(ended == 0);
}

TEST_CASE("a job may write to a file that is open, behind what is in it") {
    const TemporaryFolder folder;
    const auto file = ClaimedFile::claim(folder / "log");
    REQUIRE(file.has_value());
    file->append("before\n");
    Job job = shell(folder, "log", "echo said");
    job.output_descriptor = file->descriptor();
    run_these("/bin/sh", {job}, 1, [](std::size_t, int) { return std::nullopt; });
    CHECK(content_of(folder / "log") == "before\nsaid\n");
}
