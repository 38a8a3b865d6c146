#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "io/files/scratch_directory.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd::test {

/// A file of the given bytes in a directory of its own, both gone at the end of the scope.
class WrittenFile {
  public:
    explicit WrittenFile(std::string_view text, const std::string& name = "start.txt")
        : path_(directory_.path() / name) {
        rewrite(text);
    }

    void rewrite(std::string_view text) const {
        std::ofstream file(path_, std::ios::binary | std::ios::trunc);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
    }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_.path(); }

  private:
    ScratchDirectory directory_;
    std::filesystem::path path_;
};

/// The message of the DataError that the action throws; "no DataError" when it throws none.
template <class Action>
std::string data_error(Action&& action) {
    try {
        action();
    } catch (const DataError& error) {
        return error.what();
    }
    return "no DataError";
}

/// One malformed file: the message must contain "start.txt:<line>: " and the fragment.
struct Malformed {
    int line;
    std::string fragment;
    std::string text;
};

}  // namespace ljmd::test
