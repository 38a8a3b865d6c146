#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>

#include "io/files/output_file.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// Write a row of text for each of many atoms: threads share the formatting, which takes most of the time, and the file
/// gets the rows in their order.
/// @param append  appends row k, with its line end; called by all threads
/// @throws what `append` and OutputFile::write() throw
void write_rows(OutputFile& file, const Execution& execution, std::size_t rows,
                const std::function<void(std::size_t k, fmt::memory_buffer& text)>& append);

/// The id in the file of the atom of this id in the state: from 1, or as in the source of a copy.
[[nodiscard]] inline Index id_of(const FrameContents& contents, std::size_t id) {
    return contents.source && !contents.source->ids.empty() ? contents.source->ids[id] : static_cast<Index>(id) + 1;
}

/// Append the three numbers of a vector, a space before each.
void append_vector(const Vec3& v, fmt::memory_buffer& text);

}  // namespace ljmd
