#pragma once

#include "ljmd/detail/core/archive.hpp"

namespace ljmd::test {

/// Give an object what another one has archived. @throws CheckpointError when it cannot be
template <class T>
void through_archive(T& from, T& to) {
    Archive written;
    from.archive(written);
    Archive read(written.bytes());
    to.archive(read);
}

}  // namespace ljmd::test
