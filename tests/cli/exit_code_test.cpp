#include "cli/exit_code.hpp"

#include <new>
#include <stdexcept>

#include "deck/deck_fixtures.hpp"
#include "execution/thread_team.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "run/output_guard.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

struct Report {
    int code;
    std::string text;
};

template <class Exception>
Report report(const Exception& exception) {
    Report result{};
    result.text = said([&] {
                      try {
                          throw exception;
                      } catch (...) {
                          result.code = report_current_exception();
                      }
                  }).err;
    return result;
}

}  // namespace

TEST_CASE("every kind of error has its exit code and one message") {
    CHECK(report(InputError("the deck")).code == 2);
    CHECK(report(InputError("the deck")).text == "error: the deck\n");
    CHECK(report(InputError("error: deck.toml:1:1: a key")).text == "error: deck.toml:1:1: a key\n");
    const OutputRefused refused("it is there.", {{"choose another directory", " with --out"}});
    CHECK(report(refused).code == 2);
    CHECK(report(refused).text == "error: it is there.\n  choose another directory with --out\n");
    CHECK(report(DataError("the start")).code == 3);
    CHECK(report(FileError("the disk")).code == 4);
    CHECK(report(PhysicsError("the run")).code == 5);
    CHECK(report(PhysicsError("the run")).text == "error: the run\n");
    CHECK(report(CheckpointError("damaged")).code == 6);
    CHECK(report(ThreadsError("1 thread")).code == 7);
    CHECK(report(ProcessesError("no process")).code == 7);
    CHECK(report(ThreadsError("1 thread")).text == "error: 1 thread\n");
    CHECK(report(InUseError("another")).code == 9);
    CHECK(report(Interrupted("stopped", 143)).code == 143);
    CHECK(report(Interrupted("stopped", 143)).text == "stopped\n");
    CHECK(report(std::bad_alloc()).code == 7);
    CHECK_THAT(report(std::bad_alloc()).text, Catch::StartsWith("error: out of memory"));
    for (const Report& bug : {report(std::runtime_error("odd")), report(ContractViolation("odd"))}) {
        CHECK(bug.code == 1);
        CHECK_THAT(bug.text, Catch::StartsWith("internal error: odd\n") && Contains("bug"));
    }
}
