#include "io/files/pipe.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("what is written into a pipe is read from it, and its end is seen when the writer has closed it") {
    Pipe pipe;
    REQUIRE(::write(pipe.write_end(), "ab", 2) == 2);
    pipe.close_write_end();
    CHECK(pipe.write_end() == -1);
    char text[4] = {};
    CHECK(::read(pipe.read_end(), text, 4) == 2);
    CHECK(std::string(text) == "ab");
    CHECK(::read(pipe.read_end(), text, 4) == 0);
}

TEST_CASE("no program that is started inherits a pipe, and it is closed at the end of its scope") {
    int ends[2] = {};
    {
        const Pipe pipe;
        ends[0] = pipe.read_end();
        ends[1] = pipe.write_end();
        for (const int end : ends) {
            CHECK(::fcntl(end, F_GETFD) == FD_CLOEXEC);
        }
    }
    for (const int end : ends) {
        CHECK(::fcntl(end, F_GETFD) == -1);
    }
}
