#include "disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <utility>

namespace ljmd::faults {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_length = 4096;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::uint64_t inode_of(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        std::abort();
    }
    return status.st_ino;
}

/// Some blocks as they are, some as they were; what was never written is zero.
std::string mixed(const std::string& now, std::string before, std::mt19937_64& random) {
    const std::size_t length = random() % 2 == 0 ? now.size() : before.size();
    before.resize(length, '\0');
    for (std::size_t begin = 0; begin < std::min(length, now.size()); begin += block_length) {
        if (random() % 2 == 0) {
            const std::size_t end = std::min({begin + block_length, length, now.size()});
            std::copy(now.begin() + static_cast<std::ptrdiff_t>(begin), now.begin() + static_cast<std::ptrdiff_t>(end),
                      before.begin() + static_cast<std::ptrdiff_t>(begin));
        }
    }
    return before;
}

}  // namespace

Disk::Disk(fs::path folder) : folder_(fs::canonical(folder)) {
    remember_names(folder_, inode_of(folder_));
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
        if (entry.is_directory()) {
            remember_names(entry.path(), inode_of(entry.path()));
        } else {
            content_of(entry.path(), inode_of(entry.path())) = read(entry.path());
        }
    }
}

std::string& Disk::content_of(const fs::path& path, Inode inode) {
    const auto [file, is_new] = files_.try_emplace(inode);
    if (is_new && (file->second.held = ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) < 0) {
        std::abort();
    }
    return file->second.bytes;
}

void Disk::remember_names(const fs::path& path, Inode inode) {
    Names names;
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
        const Inode child = inode_of(entry.path());
        names[entry.path().filename().string()] = child;
        // What was never synced itself is empty.
        if (entry.is_directory()) {
            folders_.try_emplace(child);
        } else {
            content_of(entry.path(), child);
        }
    }
    folders_[inode] = std::move(names);
}

void Disk::synced(int descriptor) {
    const fs::path by_descriptor = "/proc/self/fd/" + std::to_string(descriptor);
    const fs::path path = fs::read_symlink(by_descriptor);
    if (std::mismatch(folder_.begin(), folder_.end(), path.begin(), path.end()).first != folder_.end()) {
        return;
    }
    // Through the descriptor, as the file may have been renamed.
    if (fs::is_directory(by_descriptor)) {
        remember_names(path, inode_of(by_descriptor));
    } else {
        content_of(by_descriptor, inode_of(by_descriptor)) = read(by_descriptor);
    }
}

void Disk::add_synced_names(Inode inode, const fs::path& path, Tree& tree) const {
    for (const auto& [name, child] : folders_.at(inode)) {
        if (const auto file = files_.find(child); file != files_.end()) {
            tree[path / name] = file->second.bytes;
        } else {
            tree[path / name] = std::nullopt;
            add_synced_names(child, path / name, tree);
        }
    }
}

Disk::Tree Disk::tree_with_names(Rest rest, std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    Tree tree;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
        const fs::path path = fs::relative(entry.path(), folder_);
        if (entry.is_directory()) {
            tree[path] = std::nullopt;
            continue;
        }
        const auto file = files_.find(inode_of(entry.path()));
        std::string bytes = file == files_.end() ? "" : file->second.bytes;
        tree[path] = rest == Rest::blocks ? mixed(read(entry.path()), std::move(bytes), random) : std::move(bytes);
    }
    return tree;
}

void Disk::cut(Rest rest, std::uint64_t seed) const {
    Tree tree;
    if (rest == Rest::none) {
        add_synced_names(inode_of(folder_), {}, tree);
    } else {
        tree = tree_with_names(rest, seed);
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        fs::remove_all(entry.path());
    }
    for (const auto& [path, bytes] : tree) {
        if (bytes) {
            std::ofstream(folder_ / path, std::ios::binary) << *bytes;
        } else {
            fs::create_directory(folder_ / path);
        }
    }
}

}  // namespace ljmd::faults
