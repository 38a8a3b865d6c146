#include "io/files/pipe.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "ljmd/core/errors.hpp"

namespace ljmd {

Pipe::Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0) {
        throw FileError("cannot make a pipe: " + std::generic_category().message(errno));
    }
}

Pipe::~Pipe() {
    close_read_end();
    close_write_end();
}

void Pipe::close_end(int& end) {
    if (end >= 0) {
        ::close(end);
        end = -1;
    }
}

}  // namespace ljmd
