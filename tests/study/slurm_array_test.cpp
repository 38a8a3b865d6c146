#include "ljmd/study/slurm_array.hpp"

#include <catch2/catch.hpp>

#include "ljmd/core/errors.hpp"

using namespace ljmd;
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

TEST_CASE("options that ljmd sets itself are refused, in each form that sbatch takes") {
    for (const std::string text : {"--array=1-3", "--array 1-3", "-a 1-3", "-a1-3", "--arr=1-3", "--job-name=mine",
                                   "--job-name mine", "-J mine", "-Jmine", "--job-n=mine", "-p all '--array=1-3'"}) {
        CAPTURE(text);
        CHECK_THROWS_WITH(sbatch_options(text),
                          Catch::Contains("cannot be given") && Catch::Contains("Nothing was run."));
    }
    CHECK(sbatch_options("-A project -p all --account=a --acctg-freq=5 --time 1:00 -t8 --comment=--array") ==
          Words{"-A", "project", "-p", "all", "--account=a", "--acctg-freq=5", "--time", "1:00", "-t8",
                "--comment=--array"});
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
