#pragma once

#include <string>
#include <vector>

#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// A short run, and a hash of its digits: of the atoms at the end, by id, and of all samples.
struct DigitsOfRun {
    std::string problem;  ///< what is run
    std::string rule;     ///< see digits_rule()
    std::string wanted;   ///< that this version gives on every machine, 16 hexadecimal digits
    std::string found;

    [[nodiscard]] bool right() const { return found == wanted; }
};

/// Run problems that take a second or two together, in double and mixed precision, and compare their digits with those
/// that this version has on every machine.
/// @param options  threads and SIMD level; each problem has its own precision
/// @throws InputError for a level with digits of its own
[[nodiscard]] std::vector<DigitsOfRun> verify_digits(const ExecutionOptions& options);

}  // namespace ljmd
