#pragma once

#include <cstddef>

namespace ljmd {

/// Resize a vector, with room for a sixteenth more where it has to grow. resize() alone may double its memory, which
/// wastes too much for data of all atoms.
template <class Vector>
void resize_tightly(Vector& vector, std::size_t size) {
    if (size > vector.capacity()) {
        vector.reserve(size + size / 16);
    }
    vector.resize(size);
}

}  // namespace ljmd
