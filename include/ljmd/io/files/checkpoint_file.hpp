#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ljmd/io/files/open_directory.hpp"

namespace ljmd {

/// The checkpoints of a run: generations in the files checkpoint.1, checkpoint.2, ... of its directory. A new one takes
/// the place of the oldest, so that the newest whole one is never touched.
///
/// A file is, little-endian: "LJMDCKPT"; version of the format (32 bits); zero (32 bits); generation (64 bits), which
/// grows by one from file to file; length of the content (64 bits); the content; XXH3 (128 bits) of all that;
/// "LJMDEND\n".
class CheckpointStore {
  public:
    /// @param keep  generations, >= 1
    CheckpointStore(OpenDirectory directory, int keep);

    /// Write the next generation (see ReplacementFile), read back and compared before it takes its place.
    /// @throws FileError; then the generations that were there still are
    void write(std::span<const std::byte> content);

    /// Go on after this generation, whatever newer ones there are: with keep > 1 the next one does not replace it.
    void go_on_after(std::uint64_t generation) { generation_ = generation; }

  private:
    OpenDirectory directory_;
    int keep_;
    std::uint64_t generation_ = 0;
};

/// One generation, whole.
struct CheckpointFile {
    std::filesystem::path path;
    std::uint64_t generation = 0;
    std::vector<std::byte> content;
};

/// What lies in a directory.
struct FoundCheckpoints {
    std::vector<CheckpointFile> whole;  ///< newest first
    std::vector<std::string> damaged;   ///< a line each: the file, and what is wrong with it
};

/// Read all generations in a directory. A file is taken only if every bit of it is what was written.
[[nodiscard]] FoundCheckpoints find_checkpoints(const std::filesystem::path& directory);

/// The names that checkpoints may have, whether there are such files or not.
[[nodiscard]] std::vector<std::string> checkpoint_names();

}  // namespace ljmd
