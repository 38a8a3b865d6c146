#include "io/formats/row_writer.hpp"

#include <fmt/compile.h>

#include <string_view>
#include <vector>

#include "execution/loops.hpp"

namespace ljmd {

void write_rows(OutputFile& file, const Execution& execution, std::size_t rows,
                const std::function<void(std::size_t, fmt::memory_buffer&)>& append) {
    constexpr std::size_t rows_of_block = 256;
    std::vector<fmt::memory_buffer> blocks((rows + rows_of_block - 1) / rows_of_block);
    for_each_block(execution, static_cast<Index>(rows), Index{rows_of_block}, [&](Index first, Index last) {
        fmt::memory_buffer& text = blocks[static_cast<std::size_t>(first) / rows_of_block];
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
            append(k, text);
        }
    });
    for (const fmt::memory_buffer& text : blocks) {
        file.write(std::string_view(text.data(), text.size()));
    }
}

void append_vector(const Vec3& v, fmt::memory_buffer& text) {
    fmt::format_to(fmt::appender(text), FMT_COMPILE(" {} {} {}"), v[0], v[1], v[2]);
}

}  // namespace ljmd
