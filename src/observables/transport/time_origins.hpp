#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "observables/transport/lag_times.hpp"

namespace ljmd {

// Functions of two configurations a time apart are averaged over time origins: configurations that are kept until all
// times after them have passed. They are equally spaced, the first one at the first configuration of a stage.

/// Configurations from one time origin to the next, for so many origins within the largest time. @pre origins >= 1
[[nodiscard]] inline Index frames_between_origins(const LagTimes& lags, Index origins) {
    return std::max((lags.count + origins - 1) / origins, Index{1});
}

/// Require that the time origins of a checkpoint are those that an analysis has kept after so many configurations.
/// @param origins   oldest first
/// @param most      largest age of one that is kept; the age is 1 when it has just been added
/// @param is_sound  whether an origin is one of that age: is_sound(origin, age)
/// @param whose     "this displacement", for messages
/// @throws CheckpointError
template <class Origin, class IsSound>
void require_origins(const std::vector<Origin>& origins, Index frames, Index between, Index most,
                     const IsSound& is_sound, const std::string& whose) {
    // They are at the frames n between with 0 < age = frames - n between <= most.
    Index age = frames == 0 ? 0 : (frames - 1) % between + 1;
    for (auto origin = origins.rbegin(); origin != origins.rend(); ++origin, age += between) {
        if (age < 1 || age > std::min(frames, most) || !is_sound(*origin, age)) {
            throw CheckpointError("its time origins are not those of " + whose);
        }
    }
    if (age <= std::min(frames, most) && age > 0) {
        throw CheckpointError("it lacks time origins of " + whose);
    }
}

}  // namespace ljmd
