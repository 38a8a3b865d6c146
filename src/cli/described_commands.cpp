#include "ljmd/cli/described_commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "ljmd/cli/streams.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/options/diagnostics.hpp"

namespace ljmd {

namespace {

constexpr int usage_error = 2;

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
    for (const char* addition : {":INT in [", ":{"}) {
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

Command described(const CLI::App& app) {
    Command found{app.get_name(), app.get_description(), {}};
    for (const CLI::Option* option : app.get_options()) {
        found.options.push_back(described(*option));
    }
    return found;
}

}  // namespace

std::shared_ptr<CLI::Formatter> screen_formatter() {
    return std::make_shared<ScreenFormatter>();
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

CommandTree command_tree(const CLI::App& app, const std::string& version) {
    CommandTree tree{described(app), version, {}};
    for (const CLI::App* command : commands_of(app)) {
        tree.commands.push_back(described(*command));
    }
    return tree;
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
    std::vector<std::string> commands;
    for (const CLI::App* command : commands_of(app)) {
        commands.push_back(command->get_name());
    }
    const std::string nearest = nearest_name(word, commands);
    return fmt::format("unknown command '{}'\n  {}", word,
                       nearest.empty() ? fmt::format("commands: {}", fmt::join(commands, ", "))
                                       : fmt::format("did you mean '{}'?", nearest));
}

int report_usage(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> rest = app.remaining(true);
    const std::vector<CLI::App*> used = app.get_subcommands();
    std::string message = error.what();
    // For an unknown command, CLI11's message says that a command is missing.
    if (used.empty() && !rest.empty() && !rest.front().starts_with('-')) {
        message = unknown_command(app, rest.front());
    } else {
        if (!rest.empty()) {
            message = fmt::format("not expected: {}", fmt::join(rest, " "));
        }
        message += fmt::format("\n  all options: ljmd {}--help", used.empty() ? "" : used.front()->get_name() + " ");
    }
    print_message(fmt::format("error: {}\n", message));
    return usage_error;
}

}  // namespace ljmd
