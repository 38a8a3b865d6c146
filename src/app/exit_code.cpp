#include "ljmd/app/exit_code.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <string>

#include "ljmd/app/interruption.hpp"
#include "ljmd/app/streams.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

int report_current_exception() {
    const auto say = [](const char* text) {
        const std::string message(text);
        // Diagnostics arrive with their own "error:" in front of each line that needs it.
        talk(fmt::format("{}{}\n", message.starts_with("error:") ? "" : "error: ", message));
    };
    try {
        throw;
    } catch (const InputError& e) {
        say(e.what());
        return 2;
    } catch (const DataError& e) {
        say(e.what());
        return 3;
    } catch (const FileError& e) {
        say(e.what());
        return 4;
    } catch (const PhysicsError& e) {
        say(e.what());
        return 5;
    } catch (const Interrupted& e) {
        talk(fmt::format("{}\n", e.what()));
        return e.exit_code();
    } catch (const InUseError& e) {
        say(e.what());
        return 9;
    } catch (const CheckpointError& e) {
        say(e.what());
        return 6;
    } catch (const std::bad_alloc&) {
        say("out of memory; `ljmd check` tells how much a deck needs");
        return 7;
    } catch (const std::exception& e) {
        talk(fmt::format("internal error: {}\nThis is a bug in ljmd; please report it with the deck.\n", e.what()));
        return 1;
    }
}

}  // namespace ljmd
