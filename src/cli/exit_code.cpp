#include "cli/exit_code.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <string>

#include "cli/streams.hpp"
#include "execution/ranks.hpp"
#include "execution/thread_team.hpp"
#include "io/files/process.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "run/output_guard.hpp"

namespace ljmd {

namespace {

/// Prints the message of an exception, or not.
class Reporter {
  public:
    explicit Reporter(bool aloud) : aloud_(aloud) {}

    /// @return the exit code
    int operator()(const std::string& message, int code) const {
        // Diagnostics already have "error:" in front of each line that needs it.
        print(fmt::format("{}{}\n", message.starts_with("error:") ? "" : "error: ", message));
        return code;
    }
    void print(const std::string& text) const {
        if (aloud_) {
            print_message(text);
        }
    }

  private:
    bool aloud_;
};

}  // namespace

int report_current_exception(bool aloud) {
    const Reporter say(aloud);
    try {
        throw;
    } catch (const RankLost&) {
        return 8;  // the rank that has failed says why
    } catch (const OutputRefused& e) {
        return say(e.for_commands(), 2);
    } catch (const InputError& e) {
        return say(e.what(), 2);
    } catch (const DataError& e) {
        return say(e.what(), 3);
    } catch (const FileError& e) {
        return say(e.what(), 4);
    } catch (const PhysicsError& e) {
        return say(e.what(), 5);
    } catch (const CheckpointError& e) {
        return say(e.what(), 6);
    } catch (const std::bad_alloc&) {
        return say("out of memory; `ljmd check` tells how much a deck needs", 7);
    } catch (const ThreadsError& e) {
        return say(e.what(), 7);
    } catch (const ProcessesError& e) {
        return say(e.what(), 7);
    } catch (const InUseError& e) {
        return say(e.what(), 9);
    } catch (const Interrupted& e) {
        say.print(fmt::format("{}\n", e.what()));
        return e.exit_code();
    } catch (const std::exception& e) {
        say.print(
            fmt::format("internal error: {}\nThis is a bug in ljmd; please report it with the deck.\n", e.what()));
        return 1;
    }
}

}  // namespace ljmd
