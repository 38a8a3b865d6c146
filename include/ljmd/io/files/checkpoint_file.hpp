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

/// The checkpoints of a run, in the files checkpoint.1, checkpoint.2, ... of its directory. A new generation replaces
/// the oldest file, so the newest intact one is never touched.
///
/// File format, little-endian: "LJMDCKPT"; format version (32 bits); zero (32 bits); generation (64 bits), which grows
/// by one from file to file; length of the content (64 bits); content; XXH3 (128 bits) of everything before it;
/// "LJMDEND\n".
class CheckpointStore {
  public:
    /// @param keep  number of generations, from 1 to 9
    CheckpointStore(OpenDirectory directory, int keep);

    /// Write the next generation through a ReplacementFile. It is read back and compared before it takes its place.
    /// @throws FileError; the earlier generations are then unchanged
    void write(std::span<const std::byte> content);

    /// Continue after this generation even if newer ones exist: with keep > 1 the next write does not replace it.
    void continue_after(std::uint64_t generation) { generation_ = generation; }

  private:
    OpenDirectory directory_;
    int keep_;
    std::uint64_t generation_ = 0;
};

/// An intact generation.
struct CheckpointFile {
    std::filesystem::path path;
    std::uint64_t generation = 0;
    std::vector<std::byte> content;
};

/// The checkpoint files found in a directory.
struct FoundCheckpoints {
    std::vector<CheckpointFile> whole;  ///< newest first
    std::vector<std::string> damaged;   ///< one line per file: its name and what is wrong with it
};

/// Read all generations in a directory. A file counts as intact only if every bit is as written.
[[nodiscard]] FoundCheckpoints find_checkpoints(const std::filesystem::path& directory);

/// All names that checkpoint files can have, whether the files exist or not.
[[nodiscard]] std::vector<std::string> checkpoint_names();

}  // namespace ljmd
