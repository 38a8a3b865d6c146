#include "ljmd/cli/own_commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ljmd/cli/described_commands.hpp"
#include "ljmd/cli/pages/completion.hpp"
#include "ljmd/cli/pages/man_page.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/verification/digits.hpp"
#include "ljmd/execution/threads.hpp"

namespace ljmd {

namespace {

CommandTree tree_of(const CLI::App& app) {
    return command_tree(app, build_info().version);
}

}  // namespace

OwnCommands::OwnCommands(CLI::App& app)
    : app_(app),
      init_(*app.add_subcommand("init", "write a commented deck to begin with")),
      help_(*app.add_subcommand("help", "what a command does, and its options")),
      version_(*app.add_subcommand("version", "version of the program")),
      verify_(*app.add_subcommand("verify", "run for two seconds, and compare the digits with those of every machine")),
      completion_(*app.add_subcommand("completion", "script with which a shell completes commands, options and keys")) {
    CLI::App& init = *app.get_subcommand("init");
    init.add_option("file", begun_.file, "deck to write, EXAMPLE.toml by default")->type_name("FILE");
    init.add_option("--example", begun_.example, "the deck of that name; first by default")->type_name("EXAMPLE");
    init.add_flag("--force", begun_.force, "replace the file if it exists");
    init.add_flag("--list", begun_.list, "print names and titles of the examples; nothing is written");
    CLI::App& help = *app.get_subcommand("help");
    CLI::Option* one = help.add_option("command", command_, "without one, all are listed")->type_name("COMMAND");
    help.add_flag("--man", man_, "print the manual page, for `man -l -`")->excludes(one);
    CLI::App& verify = *app.get_subcommand("verify");
    verify.add_option("--threads", threads_, "threads to share the work; no digit depends on it")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    verify.add_option("--simd", simd_, "instruction set of the kernels, one that `ljmd info` lists")
        ->type_name("LEVEL");
    verify.add_flag("--json", json_, "print the result as JSON");
    app.get_subcommand("completion")
        ->add_option("shell", shell_, "bash, fish or zsh")
        ->required()
        ->type_name("SHELL")
        ->check(CLI::IsMember({"bash", "fish", "zsh"}));
}

bool OwnCommands::parsed() const {
    return init_.parsed() || help_.parsed() || version_.parsed() || verify_.parsed() || completion_.parsed();
}

int OwnCommands::run() const {
    if (help_.parsed()) {
        return help();
    }
    if (verify_.parsed()) {
        return verify();
    }
    if (init_.parsed()) {
        init_command(begun_);
    } else if (version_.parsed()) {
        print_result(fmt::format("ljmd {}\n", build_info().version));
    } else {
        print_result(completion(tree_of(app_), shell_));
    }
    return 0;
}

int OwnCommands::help() const {
    if (man_) {
        print_result(man_page(tree_of(app_)));
        return 0;
    }
    if (command_.empty()) {
        // App::help() would be that of the command that was parsed.
        print_result(app_.get_formatter()->make_help(&app_, app_.get_name(), CLI::AppFormatMode::Normal));
        return 0;
    }
    const std::vector<const CLI::App*> commands = commands_of(app_);
    const auto found =
        std::ranges::find(commands, command_, [](const CLI::App* command) { return command->get_name(); });
    if (found == commands.end()) {
        throw InputError(unknown_command(app_, command_));
    }
    print_result((*found)->help(app_.get_name()));
    return 0;
}

int OwnCommands::verify() const {
    const SimdLevel level = default_simd_level(simd_);
    const std::vector<DigitsOfRun> runs =
        verify_digits({.threads = threads_ > 0 ? threads_ : default_thread_count(), .simd = level});
    const bool right = std::ranges::all_of(runs, &DigitsOfRun::right);
    Document report{
        {{"version", build_info().version}, {"simd", name(level)}, {"right", right}, {"runs", Data::list()}},
        fmt::format("ljmd {}, SIMD level {}\n", build_info().version, name(level))};
    for (const DigitsOfRun& run : runs) {
        report.data["runs"].push_back(
            {{"problem", run.problem}, {"digits", run.rule}, {"wanted", run.wanted}, {"found", run.found}});
        report.text += fmt::format("  {:<34} {}  {}\n", run.problem, run.found,
                                   run.right() ? "right" : fmt::format("WRONG: {} is right", run.wanted));
    }
    report.text += right ? "All digits are those that this version has on every machine.\n"
                         : "This program does not compute what this version computes elsewhere: the compiler, its "
                           "options or the machine change digits.\n";
    print_document(report, json_);
    constexpr int check_failed = 5;
    return right ? 0 : check_failed;
}

}  // namespace ljmd
