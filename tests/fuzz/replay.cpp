// Stands in for libFuzzer in the ordinary build: a target reads each file of its corpus.
//
//     fuzz_TARGET CORPUS

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
bool replayed(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    std::fprintf(stderr, "%s\n", path.c_str());  // before it is read, which may end the program
    try {
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        return true;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "    must not be thrown: %s\n", error.what());
        return false;
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s CORPUS\n", argv[0]);
        return 2;
    }
    std::error_code error;
    const fs::directory_iterator corpus(argv[1], error);
    std::vector<fs::path> files;
    if (!error) {
        std::copy(begin(corpus), end(corpus), std::back_inserter(files));
    }
    if (files.empty()) {
        std::fprintf(stderr, "%s: no corpus\n", argv[1]);
        return 1;
    }
    std::sort(files.begin(), files.end());
    const auto wrong = std::count_if(files.begin(), files.end(), [](const fs::path& path) { return !replayed(path); });
    std::fprintf(stderr, "%td of %zu files were read as they should not be\n", wrong, files.size());
    if (ljmd::fuzz::inputs_accepted == 0) {
        std::fprintf(stderr, "%s: every file is refused\n", argv[1]);
        return 1;
    }
    return wrong == 0 ? 0 : 1;
}
