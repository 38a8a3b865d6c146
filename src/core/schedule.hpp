#pragma once

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Schedule of every n-th step: 0, n, 2 n, ... with n >= 1.
class Every {
  public:
    /// @throws InputError if steps < 1
    explicit Every(Index steps) : steps_(steps) {
        if (steps < 1) {
            throw InputError("a schedule needs at least one step between events");
        }
    }

    [[nodiscard]] bool due(Index step) const { return step % steps_ == 0; }
    [[nodiscard]] Index steps() const { return steps_; }

  private:
    Index steps_;
};

}  // namespace ljmd
