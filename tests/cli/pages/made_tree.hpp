#pragma once

#include "cli/pages/command_tree.hpp"

namespace ljmd::test {

/// A program with what is hard to write down: quotes, brackets, a point at the beginning, a backslash.
inline CommandTree made_tree() {
    CommandTree tree{{"ljmd", "a program's purpose", {{{"--help", "-h"}, "", "this text"}}}, "1.2", {}};
    tree.commands.push_back({"run",
                             "run a deck",
                             {{{}, "DECK", "deck (TOML)", true},
                              {{"--set"}, "KEY=VALUE", ".toml keys: [system], it's \\n", false, true},
                              {{"--quiet", "-q"}, "", "no progress"},
                              {{"--simd"}, "LEVEL", "instruction set"},
                              {{"--walltime"}, "TIME", "limit"}}});
    tree.commands.push_back({"analyze",
                             "look at it",
                             {{{}, "RUNDIR|TRAJECTORY", "input", true},
                              {{}, "ANALYSIS", "names", false, true},
                              {{"--out"}, "DIR", "where to"}}});
    tree.commands.push_back({"version", "its number", {}});
    return tree;
}

}  // namespace ljmd::test
