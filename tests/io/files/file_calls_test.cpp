#include "../../../src/io/files/file_calls.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "io/output_fixtures.hpp"

using namespace ljmd;

TEST_CASE("an error of the system names the file and the cause") {
    CHECK(file_error("open", "a/b", ENOSPC).what() == std::string("cannot open 'a/b': No space left on device"));
}

TEST_CASE("what cannot be synced is no failure, what is not open is one") {
    int pipe[2] = {-1, -1};
    REQUIRE(::pipe(pipe) == 0);
    CHECK(sync_descriptor(pipe[1]) == 0);
    ::close(pipe[0]);
    ::close(pipe[1]);
    CHECK(sync_descriptor(pipe[1]) == EBADF);
}
