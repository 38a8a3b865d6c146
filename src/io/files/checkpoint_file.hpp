#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/files/open_directory.hpp"
#include "ljmd/detail/core/archive.hpp"

namespace ljmd {

/// The checkpoints of a run, in the files checkpoint.1, checkpoint.2, ... of its directory. A new generation replaces
/// the oldest file, so the newest intact one is never touched.
///
/// File format, little-endian: "LJMDCKPT"; format version (32 bits); zero (32 bits); generation (64 bits), which grows
/// by one from file to file; content; XXH3 (128 bits) of everything before it; "LJMDEND\n". Contents are written and
/// read piece by piece: they may be larger than memory.
class CheckpointStore {
  public:
    /// @param keep  number of generations, from 1 to 9
    CheckpointStore(OpenDirectory directory, int keep);

    /// Write the next generation through a ReplacementFile. It is read back and its hash compared before it takes its
    /// place.
    /// @param fill  writes the content
    /// @throws FileError, and what `fill` throws; the earlier generations are then unchanged
    void write(const std::function<void(Archive&)>& fill);

    /// Continue after this generation even if newer ones exist: with keep > 1 the next write does not replace it.
    void continue_after(std::uint64_t generation) { generation_ = generation; }

  private:
    OpenDirectory directory_;
    int keep_;
    std::uint64_t generation_ = 0;
};

/// An intact generation. The file stays open.
struct CheckpointFile {
    std::filesystem::path path;
    std::uint64_t generation = 0;
    std::uint64_t length = 0;  ///< of the content
    std::shared_ptr<std::ifstream> stream;
    std::string hash;  ///< of head and content, 16 bytes

    /// The content, from its beginning. Only one may be read at a time.
    [[nodiscard]] Archive content() const;
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
