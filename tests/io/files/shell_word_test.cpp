#include "io/files/shell_word.hpp"

#include "catch.hpp"

#include "io/files/input_file.hpp"
#include "io/files/process.hpp"
#include "io/files/scratch_directory.hpp"

using namespace ljmd;

TEST_CASE("a path without characters of the shell is a word as it is") {
    CHECK(shell_word("runs/first") == "runs/first");
    CHECK(shell_word("sweep/points/temperature=1.5,density=0.2") == "sweep/points/temperature=1.5,density=0.2");
}

TEST_CASE("a path with characters of the shell is a word in quotes") {
    CHECK(shell_word("two words") == "'two words'");
    CHECK(shell_word("~") == "'~'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("") == "''");
}

TEST_CASE("a path that begins like an option is none") {
    CHECK(shell_word("-x") == "./-x");
    CHECK(shell_word("a/-x") == "a/-x");
}

TEST_CASE("a shell reads every word as the path that it was made from") {
    const ScratchDirectory scratch;
    for (const std::string path :
         {"a b", "a'b", "'",     "a\"b", "$HOME", "`ls`",  "a;b", "a&b", "a|b", "*",   "a\\b",       "#a",
          "!a",  "(a)", "{a,b}", "a\nb", "\t",    "~root", "[a]", "a?",  "<a>", "a=b", "f\xc3\xbcr", ""}) {
        CAPTURE(path);
        const auto output = scratch.path() / "output";
        const int status = run_process({.program = "/bin/sh",
                                        .arguments = {"-c", "printf '%s.' " + shell_word(path)},
                                        .directory = ".",
                                        .output = output});
        CHECK(status == 0);
        CHECK(read_input(output) == path + ".");
    }
}
