#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.hpp"

namespace ljmd::test {

/// Do what a command line asks for, in this process. @throws what the command throws
inline void command(std::vector<std::string> words) {
    CommandLine line;
    line.parse(std::move(words));
    line.run();
}

}  // namespace ljmd::test
