#pragma once

#include <string>

#include "ljmd/detail/core/data.hpp"

namespace ljmd {

/// A report for programs and for people, made by one function from the same results. The two may differ in what they
/// show: tables leave out what only programs use, and data leave out advice.
struct Document {
    Data data;         ///< for programs: with --json, and in files
    std::string text;  ///< for people, with a line end
};

}  // namespace ljmd
