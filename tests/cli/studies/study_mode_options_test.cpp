#include "cli/studies/study_mode_options.hpp"

#include <algorithm>
#include "catch.hpp"

using namespace ljmd;

namespace {

/// What a command of the usual options takes from these arguments.
StudyMode mode_of(std::vector<std::string> arguments) {
    CLI::App app("test", "ljmd");
    CLI::App& command = *app.add_subcommand("study", "");
    std::string subject;
    int jobs = 0;
    bool flag = false;
    command.add_option("subject", subject)->required();
    command.add_option("--jobs", jobs);
    command.add_option("--out", subject);
    for (const char* name : {"--force", "--quiet", "--json"}) {
        command.add_flag(name, flag);
    }
    StudyMode mode;
    add_study_mode(command, mode);
    std::reverse(arguments.begin(), arguments.end());
    app.parse(arguments);
    return mode;
}

}  // namespace

TEST_CASE("a study is run, prepared, worked on, submitted or looked at") {
    const StudyMode usual = mode_of({"study", "deck.toml"});
    CHECK((!usual.prepare && usual.work.empty() && !usual.slurm && !usual.status));
    CHECK(mode_of({"study", "deck.toml", "--prepare", "--force"}).prepare);
    const StudyMode worker =
        mode_of({"study", "--work", "2/8", "runs/sweep", "--jobs", "3", "--walltime", "2h", "--quiet"});
    CHECK(worker.work == "2/8");
    CHECK(worker.walltime == "2h");
    CHECK(mode_of({"study", "deck.toml", "--slurm", "-p all -t 8:00:00", "--jobs", "4"}).slurm == "-p all -t 8:00:00");
    CHECK(mode_of({"study", "deck.toml", "--slurm", ""}).slurm == "");
    CHECK(mode_of({"study", "--status", "runs/sweep", "--json"}).status);
}

TEST_CASE("options that have no effect together are refused") {
    using Words = std::vector<std::string>;
    for (const Words& words :
         {Words{"--prepare", "--work", "1/2"}, Words{"--prepare", "--slurm", ""}, Words{"--prepare", "--status"},
          Words{"--prepare", "--jobs", "2"}, Words{"--work", "1/2", "--slurm", ""}, Words{"--work", "1/2", "--status"},
          Words{"--work", "1/2", "--out", "x"}, Words{"--work", "1/2", "--force"}, Words{"--work", "1/2", "--json"},
          Words{"--status", "--slurm", ""}, Words{"--status", "--jobs", "2"}, Words{"--walltime", "2h"}}) {
        Words all{"study", "subject"};
        all.insert(all.end(), words.begin(), words.end());
        CHECK_THROWS_AS(mode_of(all), CLI::ParseError);
    }
}
