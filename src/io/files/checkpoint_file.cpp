#include "io/files/checkpoint_file.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/replacement_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "LJMDCKPT";
constexpr std::string_view end_mark = "LJMDEND\n";
constexpr std::uint32_t format_version = 2;
constexpr int max_generations = 9;

/// The header of a file, before the content.
struct Head {
    std::array<char, magic.size()> word;
    std::uint32_t version;
    std::uint32_t zero;
    std::uint64_t generation;
};
static_assert(sizeof(Head) == 24);
constexpr std::size_t hash_length = sizeof(XXH128_canonical_t);
constexpr std::size_t tail_length = hash_length + end_mark.size();
constexpr std::size_t piece_length = std::size_t{1} << 20;

std::string name_of(std::uint64_t slot) {
    return fmt::format("checkpoint.{}", slot + 1);
}

/// The hash of bytes that come piece by piece.
class Hash {
  public:
    Hash() : state_(XXH3_createState(), XXH3_freeState) {
        if (state_ == nullptr) {
            throw std::bad_alloc();
        }
        XXH3_128bits_reset(state_.get());
    }
    void add(std::string_view text) { XXH3_128bits_update(state_.get(), text.data(), text.size()); }
    [[nodiscard]] std::string digest() const {
        XXH128_canonical_t hash;
        XXH128_canonicalFromHash(&hash, XXH3_128bits_digest(state_.get()));
        return {reinterpret_cast<const char*>(&hash), hash_length};
    }

  private:
    std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

void read_exactly(std::ifstream& file, char* to, std::size_t size, const std::string& name = "it") {
    if (!file.bad()) {
        file.read(to, static_cast<std::streamsize>(size));
    }
    if (!file) {
        throw CheckpointError(fmt::format("{} {}", name, why_reading_failed()));
    }
}

/// The next bytes of a file, as a text.
std::string next(std::ifstream& file, std::size_t size) {
    std::string text(size, '\0');
    read_exactly(file, text.data(), size);
    return text;
}

/// @throws CheckpointError with the fault
CheckpointFile checked(const fs::path& path) {
    const std::optional<std::uintmax_t> found = files::size_of(path);
    if (!found) {  // opening a pipe could block
        throw CheckpointError("it is not a file");
    }
    const std::uintmax_t size = *found;
    if (size == 0) {  // so are files of /proc, which may block
        throw CheckpointError("it is empty");
    }
    const auto file = std::make_shared<std::ifstream>(open_input(path));
    Head head{};
    file->read(reinterpret_cast<char*>(&head), sizeof(Head));
    if (file->bad()) {
        throw CheckpointError("it " + why_reading_failed());
    }
    if (std::string_view(head.word.data(), head.word.size()) != magic) {
        throw CheckpointError("it is not a checkpoint");
    }
    if (!*file || size < sizeof(Head) + tail_length) {
        throw CheckpointError("it is damaged: it is too short");
    }
    const std::uintmax_t length = size - sizeof(Head) - tail_length;
    Hash hash;
    hash.add({reinterpret_cast<const char*>(&head), sizeof(Head)});
    for (std::uintmax_t done = 0; done < length; done += piece_length) {
        hash.add(next(*file, static_cast<std::size_t>(std::min<std::uintmax_t>(piece_length, length - done))));
    }
    if (next(*file, hash_length) != hash.digest() || next(*file, end_mark.size()) != end_mark) {
        throw CheckpointError("it is damaged: its checksum is not that of its content");
    }
    if (head.version != format_version) {
        throw CheckpointError(fmt::format("it has version {} of the format, and this ljmd reads version {}",
                                          head.version, format_version));
    }
    if (head.zero != 0) {
        throw CheckpointError("its head holds something unknown");
    }
    return {path, head.generation, length, file, hash.digest()};
}

}  // namespace

Archive CheckpointFile::content() const {
    go_to(*stream, sizeof(Head));
    return {length, [file = stream, name = path.string()](std::span<std::byte> piece) {
                read_exactly(*file, reinterpret_cast<char*>(piece.data()), piece.size(), name);
            }};
}

CheckpointStore::CheckpointStore(OpenDirectory directory, int keep) : directory_(std::move(directory)), keep_(keep) {
    if (keep < 1 || keep > max_generations) {
        throw ContractViolation(fmt::format("{} generations of checkpoints cannot be kept", keep));
    }
}

void CheckpointStore::write(const std::function<void(Archive&)>& fill) {
    const std::uint64_t generation = generation_ + 1;
    const OutputPlace place = directory_ / name_of(generation % static_cast<std::uint64_t>(keep_));
    write_file_atomically(place, [&](OutputFile& file) {
        Hash hash;
        const auto put = [&](std::string_view text) {
            hash.add(text);
            file.write(text);
        };
        Head head{{}, format_version, 0, generation};
        magic.copy(head.word.data(), magic.size());
        put({reinterpret_cast<const char*>(&head), sizeof(Head)});
        Archive content([&put](std::span<const std::byte> bytes) {
            const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
            for (std::size_t from = 0; from < text.size(); from += piece_length) {
                put(text.substr(from, piece_length));  // the file has a buffer, which a long text would lengthen
            }
        });
        fill(content);
        content.flush();
        put(hash.digest());
        put(end_mark);
        file.flush();
        Hash found;
        file.read_back([&found](std::string_view piece) { found.add(piece); });
        if (found.digest() != hash.digest()) {
            throw FileError(
                fmt::format("cannot write '{}': it does not read back as it was written", file.path().string()));
        }
    });
    generation_ = generation;
}

std::vector<std::string> checkpoint_names() {
    std::vector<std::string> names;
    for (std::uint64_t slot = 0; slot < max_generations; ++slot) {
        names.push_back(name_of(slot));
    }
    return names;
}

FoundCheckpoints find_checkpoints(const fs::path& directory) {
    FoundCheckpoints found;
    for (const std::string& name : checkpoint_names()) {
        const fs::path path = directory / name;
        try {
            if (!files::is_taken(path)) {
                continue;
            }
            found.whole.push_back(checked(path));
        } catch (const CheckpointError& why) {
            found.damaged.push_back(fmt::format("{}: {}", path.string(), why.what()));
        } catch (const Error& why) {  // the file system failed
            found.damaged.emplace_back(why.what());
        }
    }
    std::sort(found.whole.begin(), found.whole.end(),
              [](const CheckpointFile& a, const CheckpointFile& b) { return a.generation > b.generation; });
    return found;
}

}  // namespace ljmd
