#include "ljmd/detail/core/archive.hpp"

#include <fmt/format.h>

#include <cstring>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Bytes that are passed on at once.
constexpr std::size_t large = std::size_t{1} << 16;

}  // namespace

void Archive::refuse(const char* why) {
    throw CheckpointError(why);
}

Archive::Archive(std::span<const std::byte> bytes)
    : read_([rest = bytes](std::span<std::byte> piece) mutable {
          std::memcpy(piece.data(), rest.data(), piece.size());
          rest = rest.subspan(piece.size());
      }),
      left_(bytes.size()),
      reading_(true) {}

void Archive::raw(void* data, std::size_t size) {
    if (size == 0) {
        return;  // a null pointer may come with it
    }
    if (reading_) {
        if (size > left_) {
            refuse("it ends too early");
        }
        read_({static_cast<std::byte*>(data), size});
        left_ -= size;
        return;
    }
    const std::span bytes(static_cast<const std::byte*>(data), size);
    if (write_ && size >= large) {
        flush();
        write_(bytes);
        return;
    }
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    if (write_ && bytes_.size() >= large) {
        flush();
    }
}

void Archive::flush() {
    if (write_) {
        write_(bytes_);
        bytes_.clear();
    }
}

std::size_t Archive::length(std::size_t length, std::size_t min_bytes) {
    std::uint64_t count = length;
    one(count);
    if (reading_ && count > left_ / min_bytes) {
        refuse("a list is longer than the rest of the file");
    }
    return static_cast<std::size_t>(count);
}

void Archive::one(bool& value) {
    auto byte = static_cast<std::uint8_t>(value);
    raw(&byte, 1);
    if (byte > 1) {
        refuse("a flag is neither 0 nor 1");
    }
    value = byte == 1;
}

void Archive::one(std::string& text) {
    const std::size_t count = length(text.size(), 1);
    if (reading_) {
        text.resize(count);
    }
    raw(text.data(), count);
}

void Archive::mark(std::string_view name) {
    std::string found(name);
    one(found);
    if (found != name) {
        throw CheckpointError(fmt::format("'{}' was expected, and something else was found", name));
    }
}

void Archive::expect_end() const {
    if (left_ > 0) {
        refuse("something follows its end");
    }
}

}  // namespace ljmd
