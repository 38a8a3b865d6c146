#pragma once

#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/engine/mistakes.hpp"

namespace ljmd {

/// Report mistakes at their places in a deck. Those that rest on a value which validation has found wrong are left out:
/// its stand-in says nothing about the deck, and each mistake is reported once.
void report(const std::vector<Mistake>& mistakes, const Section& root, Diagnostics& diagnostics);

}  // namespace ljmd
