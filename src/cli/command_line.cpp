#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <utility>

#include "cli/exit_code.hpp"
#include "cli/ranks.hpp"
#include "cli/streams.hpp"
#include "core/text.hpp"
#include "execution/launched_ranks.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

namespace {

constexpr int usage_error = 2;

/// Headings of the list of commands, one for each Part. CLI11 lists nothing that has none.
constexpr std::array headings{"Runs", "Studies", "Results", "Other programs", "The program", ""};

/// Breaks descriptions, which CLI11 leaves as long as they are.
class ScreenFormatter : public CLI::Formatter {
  public:
    std::string make_option_desc(const CLI::Option* option) const override {
        return in_column(option->get_description());
    }

    std::string make_subcommand(const CLI::App* command) const override {
        std::ostringstream text;
        CLI::detail::format_help(text, command->get_name(), in_column(command->get_description()), get_column_width());
        return text.str();
    }

  private:
    [[nodiscard]] std::string in_column(const std::string& text) const {
        return wrapped(text, screen_columns - get_column_width(), 0);
    }
};

/// The word for the values of an option, without what CLI11 adds about their range.
std::string value_word(const CLI::Option& option) {
    std::string word = option.get_items_expected_max() == 0 ? "" : option.get_type_name();
    for (const char* addition : {":INT in [", ":{", ":POSITIVE"}) {
        word.resize(std::min(word.find(addition), word.size()));
    }
    return word;
}

CommandOption described(const CLI::Option& option) {
    CommandOption found{
        {}, value_word(option), option.get_description(), option.get_required(), option.get_items_expected_max() > 1};
    for (const std::string& name : option.get_lnames()) {
        found.names.push_back("--" + name);
    }
    for (const std::string& name : option.get_snames()) {
        found.names.push_back("-" + name);
    }
    return found;
}

DescribedCommand described(const CLI::App& app) {
    DescribedCommand found{app.get_name(), app.get_description(), {}};
    for (const CLI::Option* option : app.get_options()) {
        found.options.push_back(described(*option));
    }
    return found;
}

/// Report a wrong command line. @return the exit code
int report_usage(const CLI::App& program, const CLI::ParseError& error) {
    const std::vector<std::string> rest = program.remaining(true);
    const std::vector<CLI::App*> used = program.get_subcommands();
    std::string message = error.what();
    // For an unknown command, CLI11's message says that a command is missing.
    if (used.empty() && !rest.empty() && !rest.front().starts_with('-')) {
        message = unknown_command(program, rest.front());
    } else {
        if (!rest.empty()) {
            message = fmt::format("not expected: {}", fmt::join(rest, " "));
        }
        message += fmt::format("\n  all options: ljmd {}--help", used.empty() ? "" : used.front()->get_name() + " ");
    }
    print_message(fmt::format("error: {}\n", message));
    return usage_error;
}

/// Print the text for --help or --version. @return the exit code
int print_help(const CLI::App& program, const CLI::Success& asked) {
    std::ostringstream text;
    const int code = program.exit(asked, text);
    print_result(text.str());
    return code;
}

}  // namespace

CommandLine::CommandLine()
    : parser_("Lennard-Jones molecular dynamics: Verlet's 1967 experiment and beyond", "ljmd"),
      commands_(all_commands()) {
    std::ranges::stable_sort(commands_, {}, [](const auto& command) { return command->part(); });
    parser_.formatter(std::make_shared<ScreenFormatter>());
    parser_.require_subcommand(1);
    parser_.set_version_flag("--version", "ljmd " + build_info().version);
    for (const auto& command : commands_) {
        CLI::App& added = *parser_.add_subcommand(command->name(), command->meaning());
        added.group(headings.at(static_cast<std::size_t>(command->part())));
        command->add_options(added);
    }
}

void CommandLine::parse(std::vector<std::string> words) {
    std::ranges::reverse(words);  // as CLI11 wants them
    parser_.parse(std::move(words));
}

void CommandLine::run() {
    const std::string name = parser_.get_subcommands().front()->get_name();
    const auto command = std::ranges::find(commands_, name, [](const auto& one) { return one->name(); });
    if (!(*command)->shares_work()) {
        refuse_ranks(name);
    }
    (*command)->run();
}

int run_command_line(std::vector<std::string> words) try {
    CommandLine line;
    const bool is_heard = is_first_launched();
    if (words.empty()) {
        print_message(is_heard ? line.parser().help() : "");
        return usage_error;
    }
    try {
        line.parse(std::move(words));
    } catch (const CLI::Success& help) {
        return is_heard ? print_help(line.parser(), help) : 0;
    } catch (const CLI::ParseError& error) {
        return is_heard ? report_usage(line.parser(), error) : usage_error;
    }
    line.run();
    return 0;
} catch (...) {
    return end_after_exception();
}

CommandTree command_tree(const CLI::App& program) {
    CommandTree tree{described(program), build_info().version, {}};
    for (const CLI::App* command :
         program.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); })) {
        tree.commands.push_back(described(*command));
    }
    return tree;
}

std::string unknown_command(const CLI::App& program, const std::string& word) {
    const std::vector<std::string> commands = command_tree(program).names();
    const std::string nearest = nearest_name(word, commands);
    return fmt::format("unknown command '{}'\n  {}", word,
                       nearest.empty() ? fmt::format("commands: {}", fmt::join(commands, ", "))
                                       : fmt::format("did you mean '{}'?", nearest));
}

}  // namespace ljmd
