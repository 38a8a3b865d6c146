#pragma once

/// The whole of what programs use: `#include <ljmd/ljmd.hpp>`, and link ljmd::ljmd. docs/library.md is the tutorial.
#include "ljmd/analyze/trajectory.hpp"
#include "ljmd/engine.hpp"
#include "ljmd/run/run_in_directory.hpp"
#include "ljmd/run/spec_deck.hpp"
