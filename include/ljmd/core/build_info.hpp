#pragma once

#include <string>

namespace ljmd {

/// Where a program and its numbers come from: what run records and `ljmd info` say about the build.
struct BuildInfo {
    std::string version;           ///< "0.1.0"
    std::string commit;            ///< 40 hex digits, "-dirty" behind them if tracked files differed; or "unknown"
    std::string compiler;          ///< "GNU", "Clang", ...
    std::string compiler_version;  ///< "12.2.0"
    std::string build_type;        ///< "Release", ...
    std::string flags;             ///< compiler flags that can change numbers: all but warnings
};

/// The build of the library that is linked in. The commit is the one at the time of the last build.
[[nodiscard]] const BuildInfo& build_info();

}  // namespace ljmd
