#pragma once

#include <string>

#include "ljmd/core/data.hpp"

namespace ljmd {

/// A report for both of its readers, put together in one function: what a program reads is not the text in other
/// letters, but a number that the text has is in the data, too.
struct Document {
    Data data;         ///< for programs: with --json, and in files
    std::string text;  ///< for people, with a line end
};

}  // namespace ljmd
