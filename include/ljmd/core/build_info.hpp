#pragma once

#include <string>

namespace ljmd {

/// Build of the program, for run records and `ljmd info`.
struct BuildInfo {
    std::string version;           ///< "1.0.0"
    std::string commit;            ///< 40 hex digits, followed by "-dirty" if tracked files differ; or "unknown"
    std::string compiler;          ///< "GNU", "Clang", ...
    std::string compiler_version;  ///< "12.2.0"
    std::string build_type;        ///< "Release", ...
    std::string flags;             ///< compiler flags that can change numbers: all except warnings
};

/// Build of the library that is linked. The commit is the one at the time of the last build.
[[nodiscard]] const BuildInfo& build_info();

}  // namespace ljmd
