#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/reference/reference_values.hpp"

namespace ljmd {

/// A wanted statistical error, and whether it is reached: it is at most the wanted one, from 150 independent samples at
/// least, and no guess (is_reached()).
struct ReachedError {
    WantedError wanted;  ///< its error is NaN where it is a part of a value that is not known yet
    double error;        ///< NaN if unknown
    bool reached;
};

/// The errors that these values are to reach: those that are wanted, and of other properties the default ones, which
/// are fractions of the values (ReferenceProperty::default_error). Values that are withheld have none.
[[nodiscard]] std::vector<ReachedError> reached_errors(const std::vector<WantedError>& wanted,
                                                       const std::vector<ReferenceValue>& values);

/// Steps that each replica is to have next; nothing if it has enough: all errors are reached, or the largest number of
/// steps is. Lengths grow by sqrt(2) to 8 at a time, so that errors are looked at seldom: whoever looks always, and
/// stops at the first error that is small enough, stops where it is small by chance. In between, the length is the one
/// that the errors found let expect, and a tenth more.
/// @param steps  that they have now, > 0
[[nodiscard]] std::optional<Index> next_length(const std::vector<ReachedError>& errors, Index steps, Index max_steps);

}  // namespace ljmd
