#pragma once

#include <zlib.h>

#include <istream>
#include <streambuf>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// True for the first bytes of a file that is compressed with gzip.
[[nodiscard]] bool is_gzip(std::string_view beginning);

/// Unpacks a file that is compressed with gzip while it is read, all its members if there are several. A block is in
/// memory at a time, and no more is unpacked than a given number of bytes: a small file can be made that unpacks to any
/// length (a decompression bomb).
/// Source: P. Deutsch (1996), RFC 1952, "GZIP file format specification"
class GzipInput : public std::streambuf {
  public:
    /// @param packed  at its start; must outlive this
    /// @param limit   bytes to unpack at most
    GzipInput(std::istream& packed, Index limit);
    ~GzipInput() override;
    GzipInput(const GzipInput&) = delete;
    GzipInput& operator=(const GzipInput&) = delete;

    /// Back to the start.
    void rewind();

    /// Why there is no more to read than was read, or is in the buffer, although the file has not come to its end: it
    /// is damaged, cut off, or unpacks to too much. Empty when all is well.
    [[nodiscard]] const std::string& fault() const { return fault_; }

    /// Whether the fault is that the file was cut off.
    [[nodiscard]] bool is_cut() const { return is_cut_; }

  protected:
    int_type underflow() override;

  private:
    bool refill();
    void stop(std::string fault);

    std::istream& packed_;
    Index limit_;
    z_stream stream_{};
    std::vector<char> in_;
    std::vector<char> out_;
    Index unpacked_ = 0;
    bool in_member_ = false;
    std::string fault_;
    bool is_cut_ = false;
};

}  // namespace ljmd
