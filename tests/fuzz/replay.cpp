// Stands in for libFuzzer in the ordinary build, for all targets: one of them reads each file of its corpus.
//
//     fuzz_replay TARGET CORPUS

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz_target.hpp"

namespace {

namespace fs = std::filesystem;

/// Whether the target read the file as it should.
bool replayed(ljmd::fuzz::Target target, const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    std::fprintf(stderr, "%s\n", path.c_str());  // before it is read, which may end the program
    try {
        target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        return true;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "    must not be thrown: %s\n", error.what());
        return false;
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto& targets = ljmd::fuzz::targets();
    const auto target = argc == 3 ? targets.find(argv[1]) : targets.end();
    if (target == targets.end()) {
        std::fprintf(stderr, "usage: %s TARGET CORPUS\n", argv[0]);
        return 2;
    }
    std::error_code error;
    const fs::directory_iterator corpus(argv[2], error);
    std::vector<fs::path> files;
    if (!error) {
        std::copy(begin(corpus), end(corpus), std::back_inserter(files));
    }
    if (files.empty()) {
        std::fprintf(stderr, "%s: no corpus\n", argv[2]);
        return 1;
    }
    std::sort(files.begin(), files.end());
    const auto wrong = std::count_if(files.begin(), files.end(),
                                     [&](const fs::path& path) { return !replayed(target->second, path); });
    std::fprintf(stderr, "%td of %zu files were read as they should not be\n", wrong, files.size());
    if (ljmd::fuzz::inputs_accepted == 0) {
        std::fprintf(stderr, "%s: every file is refused\n", argv[2]);
        return 1;
    }
    return wrong == 0 ? 0 : 1;
}
