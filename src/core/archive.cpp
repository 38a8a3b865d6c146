#include "ljmd/core/archive.hpp"

#include <fmt/format.h>

#include <cstring>

#include "ljmd/core/errors.hpp"

namespace ljmd {

void Archive::refuse(const char* why) {
    throw CheckpointError(why);
}

void Archive::raw(void* data, std::size_t size) {
    if (!reading_) {
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
        return;
    }
    if (size > rest_.size()) {
        refuse("it ends too early");
    }
    if (size > 0) {  // memcpy takes no null pointer, even for zero bytes
        std::memcpy(data, rest_.data(), size);
        rest_ = rest_.subspan(size);
    }
}

std::size_t Archive::length(std::size_t length, std::size_t min_bytes) {
    std::uint64_t count = length;
    one(count);
    if (reading_ && count > rest_.size() / min_bytes) {
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
    if (!rest_.empty()) {
        refuse("something follows its end");
    }
}

}  // namespace ljmd
