#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/io/hdf5/hdf5_handle.hpp"

namespace ljmd {

/// Whether the file begins as HDF5 files do. @throws DataError when it cannot be read
[[nodiscard]] bool is_hdf5(const std::filesystem::path& path);

/// An HDF5 file that is read. Objects are named by their paths, "particles/trajectory/id". Every failure of HDF5 is a
/// DataError with file, object and cause. Memory is bounded by the size of the file, whatever extents and chunks in it
/// claim.
class Hdf5Input {
  public:
    /// @throws DataError  it is no HDF5 file, is damaged, or was not closed by a program that cannot append for readers
    explicit Hdf5Input(const std::filesystem::path& path);

    /// False for a file that its writer appended to (SWMR mode) and did not close: it may go on, or was killed.
    [[nodiscard]] bool was_closed() const { return was_closed_; }

    [[nodiscard]] const std::string& name() const { return name_; }  ///< of the file

    [[nodiscard]] bool exists(const std::string& object) const;
    [[nodiscard]] bool is_dataset(const std::string& object) const;

    /// Names of what is in a group, in alphabetical order.
    [[nodiscard]] std::vector<std::string> members(const std::string& group) const;

    /// Numbers along each axis of a dataset; none of a scalar.
    [[nodiscard]] std::vector<Index> extent(const std::string& dataset) const;

    /// All of a dataset, by rows.
    [[nodiscard]] std::vector<double> numbers(const std::string& dataset) const;
    /// The first entries along the first axis of a dataset, by rows: so many, or all where there are fewer.
    [[nodiscard]] std::vector<double> first_numbers(const std::string& dataset, Index entries) const;
    /// These entries along the first axis of a dataset, by rows.
    [[nodiscard]] std::vector<double> numbers_between(const std::string& dataset, Index begin, Index end) const;
    /// One entry along the first axis of a dataset, by rows.
    [[nodiscard]] std::vector<double> numbers_at(const std::string& dataset, Index entry) const;
    [[nodiscard]] std::vector<std::int64_t> integers(const std::string& dataset) const;
    [[nodiscard]] std::vector<std::int64_t> integers_at(const std::string& dataset, Index entry) const;

    /// The numbers of an attribute; none when there is no such attribute.
    [[nodiscard]] std::vector<double> number_attribute(const std::string& object, const std::string& name) const;
    /// The texts of an attribute, of fixed or variable length; none when there is no such attribute.
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
    Hdf5Handle links_;  ///< how they are followed: not to other files
    Hdf5Handle file_;
    bool was_closed_ = true;
    mutable std::map<std::string, Hdf5Handle> datasets_;  ///< open from the first look on: frames are read one by one
};

}  // namespace ljmd
