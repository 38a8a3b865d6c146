#include "io/files/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "io/files/gzip_input.hpp"
#include "io/files/input_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr Index largest_compression = 100;  // of text; deflate itself reaches 1032
constexpr Index default_text = Index{1} << 24;

bool separates(char c) {
    return c == ' ' || c == '\t';
}

/// from_chars accepts no leading plus sign, but files have them.
std::string_view without_plus(std::string_view field) {
    const bool plus = field.size() > 1 && field[0] == '+' && field[1] != '-' && field[1] != '+';
    return plus ? field.substr(1) : field;
}

template <class T>
std::errc parse_digits(std::string_view digits, T& value) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return end == digits.data() + digits.size() ? error : std::errc::invalid_argument;
}

std::errc parse(std::string_view field, Index& value) {
    return parse_digits(without_plus(field), value);
}

/// Fortran writes exponents of double precision with a D, which from_chars does not accept.
std::errc parse(std::string_view field, double& value) {
    const std::string_view digits = without_plus(field);
    const std::errc error = parse_digits(digits, value);
    const std::size_t exponent = digits.find_first_of("dD");
    const bool is_fortran = error == std::errc::invalid_argument && exponent != std::string_view::npos &&
                            digits.substr(0, exponent).find_first_not_of("+-.0123456789") == std::string_view::npos;
    if (!is_fortran) {
        return error;
    }
    std::string with_e(digits);
    with_e[exponent] = 'e';
    return parse_digits(with_e, value);
}

/// The first bytes of a text. The stream is left after them.
std::string beginning_of(std::istream& stream) {
    constexpr std::size_t enough = 4096;
    std::string bytes(enough, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

}  // namespace

TextFile::TextFile(const fs::path& path) : name_(path.string()), buffer_(longest_line + 1) {
    file_ = open_input(path);
    size_ = static_cast<Index>(file_.seekg(0, std::ios::end).tellg());
    if (size_ < 0) fail_at(0, why_reading_failed());
    go_to(file_, 0);
    const bool is_packed = is_gzip(beginning_of(file_));
    if (file_.bad()) fail_at(0, why_reading_failed());
    go_to(file_, 0);
    if (file_.bad()) fail_at(0, why_reading_failed());
    if (is_packed) {
        size_ = largest_compression * size_ + default_text;
        gzip_ = std::make_unique<GzipInput>(file_, size_);
    }
    stream_.rdbuf(is_packed ? static_cast<std::streambuf*>(gzip_.get()) : file_.rdbuf());
    const std::string beginning = beginning_of(stream_);
    if (stream_.bad()) fail_at(0, why_reading_failed());
    no_text_ = why_no_text(beginning);
    if (no_text_.empty() && beginning.find('\0') != std::string::npos) no_text_ = "is a binary file, not a text";
    rewind();
}

TextFile::~TextFile() = default;

bool TextFile::is_cut() const {
    return stream_.eof() && (!gzip_ || gzip_->fault().empty() || gzip_->is_cut());
}

bool TextFile::next_line() {
    if (!no_text_.empty()) fail_at(0, no_text_);
    stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    const auto taken = static_cast<Index>(stream_.gcount());
    if (stream_.bad()) fail(why_reading_failed());
    if (gzip_ && stream_.eof() && !gzip_->fault().empty()) fail(gzip_->fault());
    if (taken == 0 && stream_.eof()) return false;
    ++line_number_;
    if (stream_.fail()) fail(fmt::format("the line is longer than {} bytes", longest_line));
    bytes_left_ = std::max<Index>(0, bytes_left_ - taken);

    const auto length = static_cast<std::size_t>(stream_.eof() ? taken : taken - 1);
    line_ = std::string_view(buffer_.data(), length);
    if (line_number_ == 1 && line_.starts_with(byte_order_mark)) line_.remove_prefix(byte_order_mark.size());
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    return true;
}

void TextFile::rewind() {
    if (gzip_) {
        stream_.clear();
        gzip_->rewind();
    } else {
        go_to(stream_, 0);
        if (stream_.bad()) fail_at(0, why_reading_failed());
    }
    line_ = {};
    line_number_ = 0;
    bytes_left_ = size_;
}

void TextFile::require_room(Index atoms) {
    constexpr Index shortest_line = 2;                       // one character and the line's end
    if (atoms <= (bytes_left_ + 1) / shortest_line) return;  // + 1: the last line may lack its end
    const Index announced_in = line_number_;
    Index lines = 0;
    while (next_line()) lines += is_blank(line_) ? 0 : 1;
    fail_at(announced_in, fmt::format("the file announces {} atoms, but only {} {}", atoms, lines,
                                      lines == 1 ? "line follows" : "lines follow"));
}

std::string TextFile::at(Index line, const std::string& message) const {
    return line == 0 ? fmt::format("{}: {}", name_, message)
                     : fmt::format("{}:{}: {}{}", name_, line, context_, message);
}

void TextFile::fail_at(Index line, const std::string& message) const {
    throw DataError(at(line, message));
}

void TextFile::fail_as_lost_at(Index line, const std::string& message) const {
    throw NotFinite(at(line, message));
}

double TextFile::number(std::string_view field, std::string_view what) const {
    double value = 0.0;
    const std::errc error = parse(field, value);
    if (error == std::errc::result_out_of_range) {
        fail(fmt::format("{} is outside the range of double precision: {}", what, shown(field)));
    }
    if (error != std::errc{} || !std::isfinite(value)) {
        const std::string words = fmt::format("{} must be a finite number, found {}", what, shown(field));
        if (error != std::errc{}) fail(words);
        fail_as_lost_at(line_number_, words);
    }
    return value;
}

Index TextFile::integer(std::string_view field, std::string_view what) const {
    Index value = 0;
    const std::errc error = parse(field, value);
    if (error == std::errc::result_out_of_range) {
        fail(fmt::format("{} is outside the range of 64-bit integers: {}", what, shown(field)));
    }
    if (error != std::errc{}) fail(fmt::format("{} must be an integer, found {}", what, shown(field)));
    return value;
}

void split_fields(std::string_view text, std::vector<std::string_view>& fields) {
    // Character by character: string_view's searches for character sets are several times slower.
    fields.clear();
    std::size_t end = 0;
    while (true) {
        std::size_t begin = end;
        while (begin < text.size() && separates(text[begin])) ++begin;
        if (begin == text.size()) return;
        end = begin;
        while (end < text.size() && !separates(text[end])) ++end;
        fields.push_back(text.substr(begin, end - begin));
    }
}

bool is_blank(std::string_view text) {
    return std::all_of(text.begin(), text.end(), separates);
}

bool is_number(std::string_view field) {
    double value = 0.0;
    return parse(field, value) != std::errc::invalid_argument;
}

double number_or_nan(std::string_view field) {
    double value = 0.0;
    return parse(field, value) == std::errc{} ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

std::string shown(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string text_in_quotes = "'";
    for (const char c : text.substr(0, longest)) {
        const bool prints = c >= ' ' && c <= '~';
        text_in_quotes += prints ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
    return text_in_quotes + (text.size() > longest ? "...'" : "'");
}

}  // namespace ljmd
