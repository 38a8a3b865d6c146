#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/streams.hpp"
#include "ljmd/core/build_info.hpp"

namespace ljmd {

namespace {

class VersionCommand : public Command {
  public:
    VersionCommand() : Command("version", Part::program, "version of the program") {}

    void add_options(CLI::App& /*command*/) override {}

    void run() override { print_result(fmt::format("ljmd {}\n", build_info().version)); }
};

}  // namespace

std::shared_ptr<Command> version_command() {
    return std::make_shared<VersionCommand>();
}

}  // namespace ljmd
