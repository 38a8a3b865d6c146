#include "io/files/gzip_input.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <new>

#include "io/files/input_file.hpp"

namespace ljmd {

namespace {

constexpr std::size_t block = 65536;
constexpr int gzip_format = 16 + MAX_WBITS;  // zlib's window size for gzip format only

}  // namespace

bool is_gzip(std::string_view beginning) {
    return beginning.starts_with("\x1f\x8b");
}

GzipInput::GzipInput(std::istream& packed, Index limit)
    : packed_(packed), limit_(limit), stream_(std::make_unique<z_stream>()), in_(block), out_(block) {
    if (inflateInit2(stream_.get(), gzip_format) != Z_OK) {
        throw std::bad_alloc();
    }
}

GzipInput::~GzipInput() {
    inflateEnd(stream_.get());
}

void GzipInput::rewind() {
    inflateReset(stream_.get());
    stream_->avail_in = 0;
    unpacked_ = 0;
    in_member_ = false;
    go_to(packed_, 0);
    fault_ = packed_.bad() ? why_reading_failed() : "";
    is_cut_ = false;
    setg(nullptr, nullptr, nullptr);
}

/// Read the next block of the file. @return false at its end
bool GzipInput::refill() {
    packed_.read(in_.data(), static_cast<std::streamsize>(in_.size()));
    stream_->next_in = reinterpret_cast<Bytef*>(in_.data());
    stream_->avail_in = static_cast<uInt>(packed_.gcount());
    if (packed_.bad()) {
        stop(why_reading_failed());
    }
    return stream_->avail_in > 0;
}

void GzipInput::stop(std::string fault) {
    fault_ = std::move(fault);
}

GzipInput::int_type GzipInput::underflow() {
    while (fault_.empty()) {
        const bool at_end = stream_->avail_in == 0 && !refill();
        if (at_end && !in_member_) {
            return traits_type::eof();
        }
        if (!in_member_) {
            inflateReset(stream_.get());
            in_member_ = true;
        }
        stream_->next_out = reinterpret_cast<Bytef*>(out_.data());
        stream_->avail_out = static_cast<uInt>(out_.size());
        const int status = inflate(stream_.get(), Z_NO_FLUSH);
        in_member_ = status != Z_STREAM_END;
        const std::size_t found = out_.size() - stream_->avail_out;
        unpacked_ += static_cast<Index>(found);
        if (unpacked_ > limit_) {
            stop(fmt::format("the gzip file unpacks to more than {} bytes, which no text of its size does", limit_));
            return traits_type::eof();
        }
        if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
            stop(fmt::format("the gzip file is damaged: {}", stream_->msg != nullptr ? stream_->msg : "it is no gzip"));
        }
        if (at_end && found == 0 && in_member_ && fault_.empty()) {  // zlib had no buffered output, either
            is_cut_ = true;
            stop("the gzip file is cut off: it ends before its end mark");
        }
        if (found > 0) {
            setg(out_.data(), out_.data(), out_.data() + found);
            return traits_type::to_int_type(out_[0]);
        }
    }
    return traits_type::eof();
}

}  // namespace ljmd
