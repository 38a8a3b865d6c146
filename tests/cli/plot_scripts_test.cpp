#include "cli/plot_scripts.hpp"

#include <fstream>
#include "catch.hpp"

#include "core/environment_guard.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// A program that ends with this exit code when it is asked for modules.
std::string python(const fs::path& path, int exit_code) {
    std::ofstream(path) << "#!/bin/sh\nexit " << exit_code << '\n';
    fs::permissions(path, fs::perms::owner_all);
    return path.string();
}

void write(const fs::path& path) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "#";
}

}  // namespace

TEST_CASE("the first Python that has the modules draws") {
    const TemporaryFolder folder;
    const EnvironmentGuard unset("LJMD_PYTHON", "");
    const std::string bare = python(folder / "bare", 1);
    const std::string full = python(folder / "full", 0);
    const std::string other = python(folder / "other", 0);
    CHECK(python_for_plots({"/nowhere/python3", bare, full, other}) == full);
    CHECK_THROWS_AS(python_for_plots({bare}), InputError);
    CHECK_THROWS_WITH(python_for_plots({}), Contains("apt-get install python3-numpy python3-matplotlib") &&
                                                Contains("pip install numpy matplotlib") && Contains("LJMD_PYTHON="));
}

TEST_CASE("LJMD_PYTHON is taken, or refused, and no other then") {
    const TemporaryFolder folder;
    const std::string bare = python(folder / "bare", 1);
    const std::string full = python(folder / "full", 0);
    const std::string other = python(folder / "other", 0);
    {
        const EnvironmentGuard chosen("LJMD_PYTHON", other);
        CHECK(python_for_plots({full}) == other);
    }
    for (const std::string& wrong : {bare, std::string("/nowhere/python3")}) {
        const EnvironmentGuard chosen("LJMD_PYTHON", wrong);
        CHECK_THROWS_WITH(python_for_plots({full}), Contains(wrong) && Contains("numpy and matplotlib"));
    }
}

TEST_CASE("scripts are those of the installation, else of the build") {
    const TemporaryFolder folder;
    const fs::path bin = folder / "bin";
    CHECK_THROWS_WITH(plot_script(bin), Contains("cmake --install"));
    write(bin / "analysis/plot.py");
    CHECK(plot_script(bin) == bin / "analysis/plot.py");
    const fs::path installed = (bin / LJMD_DATA_FROM_PROGRAM / "analysis/plot.py").lexically_normal();
    write(installed);
    CHECK(plot_script(bin) == installed);
}
