#include "cli/streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

// What happens to a whole program whose streams are closed, full or abandoned is tried in tests/cli/streams.py. Here is
// what can be seen from inside.

namespace {

/// Puts another file in the place of a standard stream for as long as it lives.
class Redirected {
  public:
    Redirected(FILE* stream, int to) : stream_(stream), descriptor_(fileno(stream)), saved_(::dup(fileno(stream))) {
        std::fflush(stream_);
        ::dup2(to, descriptor_);
    }
    ~Redirected() {
        std::fflush(stream_);
        std::clearerr(stream_);
        ::dup2(saved_, descriptor_);
        ::close(saved_);
    }
    Redirected(const Redirected&) = delete;
    Redirected& operator=(const Redirected&) = delete;

  private:
    FILE* stream_;
    int descriptor_;
    int saved_;
};

struct TestPipe {
    TestPipe() { REQUIRE(::pipe(ends.data()) == 0); }
    ~TestPipe() {
        ::close(ends[0]);
        ::close(ends[1]);
    }
    TestPipe(const TestPipe&) = delete;
    TestPipe& operator=(const TestPipe&) = delete;

    [[nodiscard]] std::string read() const {
        std::array<char, 256> text{};
        const ssize_t count = ::read(ends[0], text.data(), text.size());
        return {text.data(), static_cast<std::size_t>(count)};
    }
    std::array<int, 2> ends{};
};

}  // namespace

TEST_CASE("results go to stdout, talk to stderr, at once") {
    const TestPipe results;
    const TestPipe said;
    {
        const Redirected out(stdout, results.ends[1]);
        const Redirected err(stderr, said.ends[1]);
        print_result("42\n");
        print_message("step 1\n");
    }
    CHECK(results.read() == "42\n");
    CHECK(said.read() == "step 1\n");
}

TEST_CASE("results that cannot be written are an error, talk is not") {
    const int read_only = ::open("/dev/null", O_RDONLY);
    std::string message;
    {
        const Redirected out(stdout, read_only);
        const Redirected err(stderr, read_only);
        print_message("nobody hears this\n");
        try {
            print_result("42\n");
        } catch (const FileError& error) {
            message = error.what();
        }
    }
    ::close(read_only);
    CHECK(message == "standard output: the results could not be written: Bad file descriptor");
}

TEST_CASE("a reader that goes away does not end a run") {
    prepare_standard_streams();
    const TestPipe said;
    ::close(said.ends[0]);
    const Redirected err(stderr, said.ends[1]);
    print_message("nobody hears this\n");  // would end the tests by SIGPIPE
    SUCCEED();
}

TEST_CASE("warnings are said, errors are not: those are thrown") {
    const TestPipe pipe;
    Diagnostics diagnostics;
    diagnostics.warning({}, "unlikely");
    diagnostics.error({}, "wrong");
    {
        const Redirected redirected(stderr, pipe.ends[1]);
        print_warnings(diagnostics);
    }
    CHECK(pipe.read() == "warning: unlikely\n");
}

TEST_CASE("control characters of what others have written reach neither stream") {
    const TestPipe results;
    const TestPipe said;
    {
        const Redirected out(stdout, results.ends[1]);
        const Redirected err(stderr, said.ends[1]);
        print_result("a\tb\x1B]0;title\a\r\n\xC2\x9B\xFF\xC3\x85\x7F");
        print_message("error: \x1B[2J\n");
        talk_over_line("50 % \x1B[31m\n");
    }
    CHECK(results.read() == "a\tb?]0;title??\n??\xC3\x85?");
    CHECK(said.read() == "error: ?[2J\n\r\033[?7l50 % ?[31m?\033[J\033[?7h\r");
}
