#pragma once

#include <istream>
#include <memory>
#include <streambuf>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

struct z_stream_s;  // of zlib

namespace ljmd {

/// True for the first bytes of a file that is compressed with gzip.
[[nodiscard]] bool is_gzip(std::string_view beginning);

/// Unpacks a gzip file, with all its members, while it is read. One block is in memory at a time, and the number of
/// unpacked bytes is limited: a small file can unpack to any length (a decompression bomb).
/// Source: P. Deutsch (1996), RFC 1952, "GZIP file format specification"
class GzipInput : public std::streambuf {
  public:
    /// @param packed  at its start; must outlive this
    /// @param limit   maximum number of unpacked bytes
    GzipInput(std::istream& packed, Index limit);
    ~GzipInput() override;
    GzipInput(const GzipInput&) = delete;
    GzipInput& operator=(const GzipInput&) = delete;

    /// Return to the start.
    void rewind();

    /// Why reading stopped before the end of the file: it is damaged, cut off, or unpacks to too much. Empty when there
    /// is no fault. The bytes read before it are valid.
    [[nodiscard]] const std::string& fault() const { return fault_; }

    /// Whether the fault is that the file is cut off.
    [[nodiscard]] bool is_cut() const { return is_cut_; }

  protected:
    int_type underflow() override;

  private:
    bool refill();
    void stop(std::string fault);

    std::istream& packed_;
    Index limit_;
    std::unique_ptr<z_stream_s> stream_;
    std::vector<char> in_;
    std::vector<char> out_;
    Index unpacked_ = 0;
    bool in_member_ = false;
    std::string fault_;
    bool is_cut_ = false;
};

}  // namespace ljmd
