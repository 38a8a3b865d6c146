#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/hdf5/hdf5_handle.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Whether the file begins like an HDF5 file. @throws DataError when it cannot be read
[[nodiscard]] bool is_hdf5(const std::filesystem::path& path);

/// An HDF5 file that is read. Objects are named by their paths, "particles/trajectory/id". Every failure of HDF5
/// becomes a DataError with file, object and cause. Memory is bounded by the size of the file, whatever extents and
/// chunk sizes it claims.
class Hdf5Input {
  public:
    /// @throws DataError  it is not an HDF5 file, is damaged, or was left open by a program that did not write in SWMR
    /// mode
    explicit Hdf5Input(const std::filesystem::path& path);

    /// False for a file that was written in SWMR mode and not closed: its writer is still running, or was killed.
    [[nodiscard]] bool was_closed() const { return was_closed_; }

    [[nodiscard]] const std::string& name() const { return name_; }  ///< of the file

    [[nodiscard]] bool exists(const std::string& object) const;
    [[nodiscard]] bool is_dataset(const std::string& object) const;

    /// Names of the members of a group, in alphabetical order.
    [[nodiscard]] std::vector<std::string> members(const std::string& group) const;

    /// The extent of a dataset along each axis; empty for a scalar.
    [[nodiscard]] std::vector<Index> extent(const std::string& dataset) const;

    /// All numbers of a dataset, in row-major order.
    [[nodiscard]] std::vector<double> numbers(const std::string& dataset) const;
    /// The first `entries` entries along the first axis, or all if there are fewer, in row-major order.
    [[nodiscard]] std::vector<double> first_numbers(const std::string& dataset, Index entries) const;
    /// The entries [begin, end) along the first axis, in row-major order.
    [[nodiscard]] std::vector<double> numbers_between(const std::string& dataset, Index begin, Index end) const;
    /// One entry along the first axis, in row-major order.
    [[nodiscard]] std::vector<double> numbers_at(const std::string& dataset, Index entry) const;
    [[nodiscard]] std::vector<std::int64_t> integers(const std::string& dataset) const;
    [[nodiscard]] std::vector<std::int64_t> integers_at(const std::string& dataset, Index entry) const;

    /// The numbers of an attribute; empty if there is no such attribute.
    [[nodiscard]] std::vector<double> number_attribute(const std::string& object, const std::string& name) const;
    /// The texts of an attribute, of fixed or variable length; empty if there is no such attribute.
    [[nodiscard]] std::vector<std::string> text_attribute(const std::string& object, const std::string& name) const;

    /// @throws DataError always, "FILE: message"
    [[noreturn]] void fail(const std::string& message) const;

  private:
    struct Entries {
        Index begin;
        Index end;
    };
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& dataset, std::optional<Entries> entries) const;
    [[nodiscard]] Hdf5Handle open(const std::string& object) const;
    [[nodiscard]] hid_t open_dataset(const std::string& dataset) const;
    struct Attribute;
    [[nodiscard]] std::optional<Attribute> open_attribute(const std::string& object, const std::string& name) const;
    [[nodiscard]] std::vector<Index> extent_of(hid_t space, const std::string& what) const;
    void require_stored(hid_t dataset, const std::string& name) const;
    [[nodiscard]] double packed_chunk_bytes(hid_t dataset, const std::string& name) const;
    hid_t checked(hid_t id, const std::string& doing) const;

    std::string name_;
    Hdf5Handle links_;  ///< link access: links to other files are refused
    Hdf5Handle file_;
    bool was_closed_ = true;
    mutable std::map<std::string, Hdf5Handle> datasets_;  ///< kept open: frames are read one by one
};

}  // namespace ljmd
