#include "io/files/gzip_input.hpp"

#include "io/formats/readable_format.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "ljmd/core/errors.hpp"

/// What needs a library that the page does without. A deck may name H5MD, for the run at home.

struct z_stream_s {};

namespace ljmd {

ReadableFormat h5md_file() {
    return {.name = "an H5MD file",
            .recognises = [](const auto&, TextFile&) { return false; },
            .configuration = [](const auto&, const ReaderOptions&) -> Configuration {
                throw DataError("a page reads no H5MD file");
            },
            .has_groups = true};
}

TrajectoryFormat h5md() {
    return {.name = "h5md",
            .meaning = "H5MD 1.1",
            .si_units = "nm, ps",
            .is_read = true,
            .make = [](const State&, const TrajectoryOptions&) -> std::unique_ptr<TrajectoryWriter> {
                throw InputError("a page writes no H5MD file");
            },
            .bytes = [](Index, Index, const AtomColumns&) { return 0.0; }};
}

bool is_gzip(std::string_view /*beginning*/) {
    return false;
}

GzipInput::GzipInput(std::istream& packed, Index limit) : packed_(packed), limit_(limit) {
    throw DataError("a page reads no compressed file");
}

GzipInput::~GzipInput() = default;

void GzipInput::rewind() {}

GzipInput::int_type GzipInput::underflow() {
    return traits_type::eof();
}

}  // namespace ljmd
