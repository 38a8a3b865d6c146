#include <algorithm>

#include "fuzz_target.hpp"
#include "io/files/text_file.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

// A text file, which is unpacked where it begins as gzip does. Whatever it holds, no more text comes out than its size
// allows.
LJMD_FUZZ_TARGET(gzip) {
    TextFile file(fuzz::file_of(data, size));
    const Index most = file.bytes_left();
    Index found = 0;
    try {
        while (file.next_line()) {
            found += std::ssize(file.line()) + 1;
        }
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    }
    fuzz::require(found <= most + 1, "more text than the size of the file allows");
    return 0;
}
