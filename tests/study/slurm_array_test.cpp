#include "study/slurm_array.hpp"

#include <csignal>
#include <fstream>
#include "catch.hpp"

#include "core/environment_guard.hpp"
#include "io/files/process.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

// That Slurm does what is asked of it is tried by tests/slurm, which starts one.

TEST_CASE("options are words as a shell separates them") {
    CHECK(shell_words("").empty());
    CHECK(shell_words("  \t\n").empty());
    CHECK(shell_words("-p all  -t 8:00:00 ") == Words{"-p", "all", "-t", "8:00:00"});
    CHECK(shell_words("--comment='two words' \"a 'b'\"c") == Words{"--comment=two words", "a 'b'c"});
    CHECK(shell_words("a\\ b 'c\\' \"d\\\"e\" ''") == Words{"a b", "c\\", "d\"e", ""});
    CHECK(shell_words("$HOME;ls *") == Words{"$HOME;ls", "*"});
    CHECK_THROWS_AS(shell_words("--comment='two words"), InputError);
    CHECK_THROWS_AS(shell_words("\"\\\""), InputError);
}

TEST_CASE("options are allowed by name, each in a word of its own, with its value") {
    for (const std::string text : {"--array=1-3",
                                   "-a 1-3",
                                   "-a1-3",
                                   "--arr=1-3",
                                   "--job-name=mine",
                                   "-J mine",
                                   "-Jmine",
                                   "-p all '--array=1-3'",
                                   "-M other",
                                   "-Mother",
                                   "--clusters=other",
                                   "-W",
                                   "--wait",
                                   "--test-only",
                                   "-Q",
                                   "--quiet",
                                   "--parsable",
                                   "--wrap=true",
                                   "-V",
                                   "--usage",
                                   "-HQ",
                                   "--part=all",
                                   "other.sh",
                                   "-p all other.sh",
                                   "--",
                                   "-",
                                   "''",
                                   "--hold=1"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(sbatch_options(text), InputError);
        CHECK_THROWS_WITH(sbatch_options(text),
                          Contains("cannot be given. Nothing was run.") && Contains("--time (-t)"));
    }
    for (const std::string text : {"-p", "-p all --time", "-H --account", "--mem=1 -A"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(sbatch_options(text), InputError);
        CHECK_THROWS_WITH(sbatch_options(text), Contains("needs a value. Nothing was run."));
    }
    CHECK(sbatch_options("-A project -p all --account=a --acctg-freq=5 --time 1:00 -t8 --comment=--array").size() ==
          10);
    CHECK(sbatch_options("-H --exclusive --exclusive=user --nice -p -M") ==
          Words{"-H", "--exclusive", "--exclusive=user", "--nice", "-p", "-M"});
}

namespace {

/// A Slurm whose programs are a few lines of shell, and a study in it.
class StandIn {
  public:
    StandIn(const std::string& squeue, const std::string& sbatch)
        : path_("PATH", (folder_ / "").string() + ":/usr/bin:/bin") {
        write("squeue", squeue);
        write("sbatch", sbatch);
        std::filesystem::create_directory(folder_ / "study");
    }
    [[nodiscard]] SlurmArray array(const Interruption& interruption = Interruption(), double seconds = 900.0) const {
        return {"sweep", folder_ / "study", "", interruption, seconds};
    }
    [[nodiscard]] std::string submitted() const { return array().submit({false, true, false}, 1, false); }

  private:
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << "#!/bin/sh\n" << text << '\n';
        std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
    }

    TemporaryFolder folder_;
    EnvironmentGuard path_;
};

}  // namespace

TEST_CASE("an array is queued if squeue says so on its stdout, and not if it says that it does not know") {
    CHECK_THROWS_AS(StandIn("echo 17 PENDING; echo careful >&2", "").array().require_none(), InUseError);
    CHECK_NOTHROW(StandIn("echo 17 COMPLETING; echo careful: 18 RUNNING >&2", "").array().require_none());
    CHECK_NOTHROW(StandIn("", "").array().require_none());
    for (const std::string squeue : {"exit 1", "echo 17 PENDING; exit 1", "echo squeue: error", "echo 17",
                                     "echo 17 PENDING all", "echo 17_2 PENDING", "kill -9 $$"}) {
        CAPTURE(squeue);
        CHECK_THROWS_AS(StandIn(squeue, "").array().require_none(), ProcessesError);
        CHECK_THROWS_WITH(StandIn(squeue, "").array().require_none(),
                          Contains("It is not known whether the study is queued"));
    }
}

TEST_CASE("an array is submitted if sbatch says so by its exit status and its number") {
    CHECK(StandIn("", "echo careful >&2; echo 17").submitted() == "array 17 of 2 tasks");
    CHECK(StandIn("", "echo '17;here'").submitted() == "array 17 of 2 tasks");
    CHECK_THROWS_AS(StandIn("", "echo refused >&2; exit 1").submitted(), InputError);
    CHECK_THROWS_WITH(StandIn("", "echo refused >&2; exit 1").submitted(),
                      Contains("Nothing was submitted.\n  refused"));
    for (const std::string sbatch : {"", "echo 17; exit 1", "echo Submitted batch job 17", "echo 17; echo 18"}) {
        CAPTURE(sbatch);
        CHECK_THROWS_AS(StandIn("", sbatch).submitted(), ProcessesError);
        CHECK_THROWS_WITH(StandIn("", sbatch).submitted(),
                          Contains("It is not known whether an array is queued: squeue --name=study-"));
    }
}

TEST_CASE("a program of Slurm that does not answer is stopped when its time is over, or when ljmd is asked to stop") {
    const StandIn hanging("sleep 10000 & wait", "");
    CHECK_THROWS_AS(hanging.array(Interruption(), 0.0).require_none(), ProcessesError);
    CHECK_THROWS_WITH(hanging.array(Interruption(), 0.0).require_none(),
                      Contains("squeue has not answered within 0 s"));
    const Interruption asked(std::nullopt, [] { return std::optional(StopRequest{SIGINT, "SIGINT"}); });
    CHECK_THROWS_AS(hanging.array(asked).require_none(), Interrupted);
    CHECK_THROWS_WITH(hanging.array(asked).require_none(), Contains("squeue was stopped before it answered"));
}

TEST_CASE("programs of Slurm get the environment without what makes them look or act elsewhere") {
    const EnvironmentGuard filter("SQUEUE_STATES", "COMPLETED");
    const EnvironmentGuard clusters("SLURM_CLUSTERS", "other");
    const EnvironmentGuard wait("SBATCH_WAIT", "1");
    const EnvironmentGuard index("SBATCH_ARRAY_INX", "7");
    const EnvironmentGuard all("SBATCH_WAIT_ALL_NODES", "1");
    const EnvironmentGuard partition("SBATCH_PARTITION", "all");
    const StandIn slurm(
        "[ -z \"$SQUEUE_STATES$SLURM_CLUSTERS\" ] && [ \"$SBATCH_PARTITION\" = all ]",
        "[ -z \"$SBATCH_WAIT$SLURM_CLUSTERS$SBATCH_ARRAY_INX\" ] && [ $SBATCH_PARTITION$SBATCH_WAIT_ALL_NODES = "
        "all1 ] && echo 17");
    CHECK_NOTHROW(slurm.array().require_none());
    CHECK(slurm.submitted() == "array 17 of 2 tasks");
}

TEST_CASE("tasks are written as ranges") {
    CHECK(array_ranges({}).empty());
    CHECK(array_ranges({4}) == "4");
    CHECK(array_ranges({1, 2}) == "1-2");
    CHECK(array_ranges({1, 3, 4, 5, 9}) == "1,3-5,9");
}

TEST_CASE("a task is submitted if any run of its share is unfinished") {
    CHECK(unfinished_tasks({false, false, false}, 3) == std::vector<std::size_t>{1, 2, 3});
    CHECK(unfinished_tasks({true, true, true, false, true}, 3) == std::vector<std::size_t>{1});
    CHECK(unfinished_tasks({true, true, true, true, false}, 2) == std::vector<std::size_t>{1});
    CHECK(unfinished_tasks({true, true}, 2).empty());
}
