#include "cli/plot_scripts.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>

#include "io/files/file_system.hpp"
#include "io/files/process.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// The modules are looked for and not imported, which would take a second. The first entry of sys.path is the working
/// directory, where a folder may have the name of a module.
constexpr auto has_modules =
    "import sys; del sys.path[0]; from importlib.util import find_spec\n"
    "sys.exit(sys.version_info < (3, 9) or not all(map(find_spec, ('numpy', 'matplotlib'))))";

bool fits(const fs::path& python) {
    return run_process(
               {.program = python, .arguments = {"-c", has_modules}, .directory = ".", .output = "/dev/null"}) == 0;
}

}  // namespace

std::vector<std::string> usual_pythons() {
    return {"python3", "/usr/bin/python3", "/usr/local/bin/python3", "/opt/homebrew/bin/python3", "python"};
}

fs::path python_for_plots(const std::vector<std::string>& candidates) {
    if (const char* chosen = std::getenv("LJMD_PYTHON"); chosen != nullptr && *chosen != '\0') {
        if (const auto python = find_program(chosen); python && fits(*python)) {
            return *python;
        }
        throw InputError(fmt::format("LJMD_PYTHON is '{}', which is no Python 3.9 with numpy and matplotlib", chosen));
    }
    for (const std::string& candidate : candidates) {
        if (const auto python = find_program(candidate); python && fits(*python)) {
            return *python;
        }
    }
    throw InputError(
        "pictures are drawn by Python 3.9 or later with numpy and matplotlib, and none was found\n"
        "  Debian, Ubuntu:  apt-get install python3-numpy python3-matplotlib\n"
        "  elsewhere:       python3 -m pip install numpy matplotlib\n"
        "  or say where it is: LJMD_PYTHON=/path/to/python3");
}

fs::path plot_script(const fs::path& program_directory) {
    const fs::path installed = (program_directory / LJMD_DATA_FROM_PROGRAM / "analysis" / "plot.py").lexically_normal();
    const fs::path built = program_directory / "analysis" / "plot.py";
    for (const fs::path& script : {installed, built}) {
        if (files::is_regular_file(script)) {
            return script;
        }
    }
    throw InputError(
        fmt::format("the scripts that draw pictures are neither in '{}' nor in '{}'; `cmake --install` puts them "
                    "beside the program",
                    installed.parent_path().string(), built.parent_path().string()));
}

}  // namespace ljmd
