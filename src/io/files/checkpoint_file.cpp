#include "ljmd/io/files/checkpoint_file.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/io/files/input_file.hpp"
#include "ljmd/io/files/replacement_file.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "LJMDCKPT";
constexpr std::string_view end_mark = "LJMDEND\n";
constexpr std::uint32_t format_version = 1;
constexpr int max_generations = 9;

/// The header of a file, before the content.
struct Head {
    std::array<char, magic.size()> word;
    std::uint32_t version;
    std::uint32_t zero;
    std::uint64_t generation;
    std::uint64_t length;
};
static_assert(sizeof(Head) == 32);
constexpr std::size_t hash_length = sizeof(XXH128_canonical_t);
constexpr std::size_t tail_length = hash_length + end_mark.size();

std::string name_of(std::uint64_t slot) {
    return fmt::format("checkpoint.{}", slot + 1);
}

/// Hash of the concatenated texts.
XXH128_canonical_t hash_of(std::initializer_list<std::string_view> texts) {
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
    if (state == nullptr) {
        throw std::bad_alloc();
    }
    XXH3_128bits_reset(state.get());
    for (const std::string_view text : texts) {
        XXH3_128bits_update(state.get(), text.data(), text.size());
    }
    XXH128_canonical_t hash;
    XXH128_canonicalFromHash(&hash, XXH3_128bits_digest(state.get()));
    return hash;
}

/// The three parts of a file. A large checkpoint is written and read back piece by piece: a full copy would be a large
/// part of the memory of a run.
using Parts = std::array<std::string_view, 3>;
constexpr std::size_t piece_length = std::size_t{1} << 20;

void write_parts(OutputFile& file, const Parts& parts) {
    for (const std::string_view part : parts) {
        for (std::size_t from = 0; from < part.size(); from += piece_length) {
            file.write(part.substr(from, piece_length));
        }
    }
    file.flush();
}

bool reads_back(const OutputFile& file, const Parts& parts) {
    std::int64_t begin = 0;
    for (const std::string_view part : parts) {
        for (std::size_t from = 0; from < part.size(); from += piece_length) {
            const std::string_view piece = part.substr(from, piece_length);
            if (!file.holds(piece, begin)) {
                return false;
            }
            begin += std::ssize(piece);
        }
    }
    return true;
}

/// A file whose length is not the one in its header is not read: the claimed length may not fit into memory.
std::string read_whole(const fs::path& path) {
    const std::optional<std::uintmax_t> found = files::size_of(path);
    if (!found) {  // opening a pipe could block
        throw CheckpointError("it is not a file");
    }
    const std::uintmax_t size = *found;
    if (size == 0) {  // so are files of /proc, which may block
        throw CheckpointError("it is empty");
    }
    std::ifstream file = open_input(path);
    Head head{};
    file.read(reinterpret_cast<char*>(&head), sizeof(Head));
    if (file.bad()) {
        throw CheckpointError("it " + why_reading_failed());
    }
    if (std::string_view(head.word.data(), head.word.size()) != magic) {
        throw CheckpointError("it is not a checkpoint");
    }
    if (!file || size < sizeof(Head) + tail_length || head.length != size - sizeof(Head) - tail_length) {
        throw CheckpointError("it is damaged: its length is not what it says");
    }
    std::string text(size, '\0');
    file.seekg(0);
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (!file) {
        throw CheckpointError("it " + why_reading_failed());
    }
    return text;
}

/// @throws CheckpointError with the fault
CheckpointFile parse(const fs::path& path) {
    const std::string text = read_whole(path);
    Head head{};
    std::memcpy(&head, text.data(), sizeof(Head));
    const std::size_t hashed = text.size() - tail_length;
    const XXH128_canonical_t hash = hash_of({std::string_view(text).substr(0, hashed)});
    const bool sound = std::memcmp(&hash, text.data() + hashed, hash_length) == 0 && text.ends_with(end_mark);
    if (!sound) {
        throw CheckpointError("it is damaged: its checksum is not that of its content");
    }
    if (head.version != format_version) {
        throw CheckpointError(fmt::format("it has version {} of the format, and this ljmd reads version {}",
                                          head.version, format_version));
    }
    if (head.zero != 0) {
        throw CheckpointError("its head holds something unknown");
    }
    const auto content = std::as_bytes(std::span(text)).subspan(sizeof(Head), static_cast<std::size_t>(head.length));
    return {path, head.generation, {content.begin(), content.end()}};
}

}  // namespace

CheckpointStore::CheckpointStore(OpenDirectory directory, int keep) : directory_(std::move(directory)), keep_(keep) {
    if (keep < 1 || keep > max_generations) {
        throw ContractViolation(fmt::format("{} generations of checkpoints cannot be kept", keep));
    }
}

void CheckpointStore::write(std::span<const std::byte> content) {
    const std::uint64_t generation = generation_ + 1;
    Head head{{}, format_version, 0, generation, content.size()};
    magic.copy(head.word.data(), magic.size());
    const std::string_view first(reinterpret_cast<const char*>(&head), sizeof(Head));
    const std::string_view second(reinterpret_cast<const char*>(content.data()), content.size());
    const XXH128_canonical_t hash = hash_of({first, second});
    std::string last(reinterpret_cast<const char*>(&hash), hash_length);
    last += end_mark;
    const Parts parts{first, second, last};
    const OutputPlace place = directory_ / name_of(generation % static_cast<std::uint64_t>(keep_));
    write_file_atomically(place, [&](OutputFile& file) {
        write_parts(file, parts);
        if (!reads_back(file, parts)) {
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
            found.whole.push_back(parse(path));
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
