#pragma once

namespace ljmd {

/// Print the message of the current exception to stderr, if aloud. @return its exit code: 1 internal, 2 usage or deck,
/// 3 input data, 4 output, 5 physics, 6 checkpoint, 7 no memory, threads or processes, 8 another rank has failed, 9
/// directory in use, 75 wall time reached, 128 + n signal
[[nodiscard]] int report_current_exception(bool aloud = true);

}  // namespace ljmd
