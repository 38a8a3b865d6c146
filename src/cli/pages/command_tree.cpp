#include "cli/pages/command_tree.hpp"

#include <algorithm>
#include <iterator>

namespace ljmd {

namespace {

std::vector<CommandOption> chosen(const std::vector<CommandOption>& options, bool arguments) {
    std::vector<CommandOption> found;
    std::ranges::copy_if(options, std::back_inserter(found),
                         [&](const CommandOption& option) { return option.is_argument() == arguments; });
    return found;
}

}  // namespace

std::vector<CommandOption> DescribedCommand::arguments() const {
    return chosen(options, true);
}

std::vector<CommandOption> DescribedCommand::named_options() const {
    return chosen(options, false);
}

std::vector<std::string> CommandTree::names() const {
    std::vector<std::string> names;
    std::ranges::transform(commands, std::back_inserter(names), &DescribedCommand::name);
    return names;
}

}  // namespace ljmd
