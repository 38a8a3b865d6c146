#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace ljmd::faults {

/// What of a folder, and of all folders in it, is on the disk, as far as a program may rely on it: the content that a
/// file had when it was last synced, under the names that its folder had when that was last synced. What is there when
/// the object is made counts as synced.
class Disk {
  public:
    /// What a power cut leaves of the rest.
    enum class Rest {
        names,   ///< new names stay, old ones are gone, contents are as they were synced
        none,    ///< names, too, are as they were synced
        blocks,  ///< as names, but every other block of a file, chosen at random, is as it was written
    };

    explicit Disk(std::filesystem::path folder);

    /// To be called after an open file or folder has been synced; one outside of the folder does not matter.
    void synced(int descriptor);

    /// Make the folder what it is after a power cut. @param seed  chooses the blocks
    void cut(Rest rest, std::uint64_t seed) const;

  private:
    using Inode = std::uint64_t;
    using Names = std::map<std::string, Inode>;
    struct Content {
        std::string bytes;
        int held = -1;  ///< a descriptor, so that the inode is not given to another file
    };
    /// Paths in the folder, and what is in the file; nothing for a folder. Parents stand before their children.
    using Tree = std::map<std::filesystem::path, std::optional<std::string>>;

    std::string& content_of(const std::filesystem::path& path, Inode inode);
    void remember_names(const std::filesystem::path& path, Inode inode);
    void add_synced_names(Inode inode, const std::filesystem::path& path, Tree& tree) const;
    Tree tree_with_names(Rest rest, std::uint64_t seed) const;

    std::filesystem::path folder_;
    std::map<Inode, Content> files_;
    std::map<Inode, Names> folders_;
};

}  // namespace ljmd::faults
