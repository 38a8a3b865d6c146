#pragma once

namespace ljmd {

/// The exit code for the exception that is being handled, after its message has been printed to stderr:
/// 1 internal, 2 usage or deck, 3 input data, 4 output, 5 physics,
/// 6 checkpoint, 7 memory, 9 directory in use, 75 wall time reached, 128 + n signal.
[[nodiscard]] int report_current_exception();

}  // namespace ljmd
