#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ljmd {

/// Serialises objects to bytes and back, for checkpoints. A class has one function for both directions, so that what is
/// read matches what was written:
///
///     void archive(Archive& a) { a(count_, mean_, pending_); }
///
/// Supports arithmetic types, enumerations, strings, vectors, arrays, pairs, optionals, Eigen matrices, and classes
/// with such a function. Numbers are stored bit for bit, little-endian; lengths precede elements. Input is not trusted:
/// it cannot make an archive read beyond its end, nor allocate more than a few times its own length.
///
/// An archive is in memory, or passes its bytes on to a file and takes them from there, so that it may be larger than
/// memory.
class Archive {
  public:
    /// For writing into memory.
    Archive() = default;

    /// For writing. @param write  takes the bytes, in order; bytes of small values come together
    using Write = std::function<void(std::span<const std::byte>)>;
    explicit Archive(Write write) : write_(std::move(write)) {}

    /// For reading. @param bytes  must outlive the archive
    explicit Archive(std::span<const std::byte> bytes);

    /// For reading. @param read  fills a piece of memory with the next bytes  @param length  of all of them
    using Read = std::function<void(std::span<std::byte>)>;
    Archive(std::uint64_t length, Read read) : read_(std::move(read)), left_(length), reading_(true) {}

    [[nodiscard]] bool reading() const { return reading_; }

    /// Write all values, or read them, in this order.
    /// @throws CheckpointError when reading, if the bytes end early or cannot be a value of that type
    template <class... Values>
    void operator()(Values&... values) {
        (one(values), ...);
    }

    /// Write a name, or require it at this place when reading, so that a mismatch is found early and by name.
    /// @throws CheckpointError
    void mark(std::string_view name);

    /// Write or read numbers whose count is known.
    template <class T>
    void numbers(std::span<T> values) {
        static_assert(std::is_arithmetic_v<T>);
        raw(values.data(), values.size_bytes());
    }
    /// Write them. @pre writing
    template <class T>
    void numbers(std::span<const T> values) {
        raw(const_cast<T*>(values.data()), values.size_bytes());  // which are only read
    }

    /// Bytes that are still to be read. @pre reading
    [[nodiscard]] std::uint64_t left() const { return left_; }

    /// All bytes written so far. @pre written into memory
    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

    /// Pass on what has not been passed on yet. @pre writing
    void flush();

    /// Require that everything has been read. @pre reading  @throws CheckpointError
    void expect_end() const;

  private:
    static_assert(std::endian::native == std::endian::little, "numbers are stored as they lie in memory");

    void raw(void* data, std::size_t size);
    [[noreturn]] static void refuse(const char* why);

    /// Write or read a number of elements, each of at least `min_bytes` bytes.
    std::size_t length(std::size_t length, std::size_t min_bytes);

    template <class T>
    void one(T& value);
    template <class T, class Allocator>
    void one(std::vector<T, Allocator>& values);
    template <class T, std::size_t count>
    void one(std::array<T, count>& values);
    template <class First, class Second>
    void one(std::pair<First, Second>& values);
    template <class T>
    void one(std::optional<T>& value);
    void one(bool& value);
    void one(std::string& text);

    std::vector<std::byte> bytes_;  // written; of an archive that passes them on, those that wait
    Write write_;                   // empty: into memory
    Read read_;
    std::uint64_t left_ = 0;  // bytes still to be read
    bool reading_ = false;
};

template <class T>
void Archive::one(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        raw(&value, sizeof(T));
    } else if constexpr (requires { value.archive(*this); }) {
        value.archive(*this);
    } else {  // an Eigen matrix
        using Scalar = typename T::Scalar;
        static_assert(std::is_arithmetic_v<Scalar>);
        std::int64_t rows = value.rows();
        std::int64_t columns = value.cols();
        one(rows);
        one(columns);
        if (reading_) {
            const auto most = static_cast<std::int64_t>(left_ / sizeof(Scalar));
            if (rows < 0 || columns < 0 || (columns > 0 && rows > most / columns)) {
                refuse("a matrix is larger than the rest of the file");
            }
            if ((T::RowsAtCompileTime >= 0 && rows != T::RowsAtCompileTime) ||
                (T::ColsAtCompileTime >= 0 && columns != T::ColsAtCompileTime)) {
                refuse("a matrix has another shape");
            }
            value.resize(rows, columns);
        }
        raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof(Scalar));
    }
}

template <class T, class Allocator>
void Archive::one(std::vector<T, Allocator>& values) {
    constexpr bool plain = std::is_arithmetic_v<T>;
    static_assert(!std::is_same_v<T, bool>);
    const std::size_t count = length(values.size(), plain ? sizeof(T) : 1);
    if (reading_) {
        values.clear();
        values.resize(count);
    }
    if constexpr (plain) {
        raw(values.data(), count * sizeof(T));
    } else {
        for (T& value : values) {
            one(value);
        }
    }
}

template <class T, std::size_t count>
void Archive::one(std::array<T, count>& values) {
    for (T& value : values) {
        one(value);
    }
}

template <class First, class Second>
void Archive::one(std::pair<First, Second>& values) {
    one(values.first);
    one(values.second);
}

template <class T>
void Archive::one(std::optional<T>& value) {
    bool there = value.has_value();
    one(there);
    if (reading_) {
        value.reset();
        if (there) {
            value.emplace();
        }
    }
    if (there) {
        one(*value);
    }
}

}  // namespace ljmd
