#include "ljmd/app/run_lock.hpp"

#include <fmt/format.h>

#include "ljmd/app/run_directory.hpp"
#include "ljmd/app/streams.hpp"

namespace ljmd {

namespace {

const std::filesystem::path& made(const std::filesystem::path& directory) {
    make_directory(directory);
    return directory;
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& directory) : lock_(directory) {
    if (settle_earlier_run(lock_.directory(), run_output_names())) {
        talk(
            fmt::format("warning: the earlier run in {} was put back: the one that was to replace it had no checkpoint "
                        "yet\n",
                        directory.string()));
    }
}

RunLock::RunLock(Deck& deck, bool force) : RunLock(made(deck.directory)) {
    check_directory(deck, force);  // again: another run may have come to its end in it since
    directory().require_at_its_path();
    earlier_.emplace(directory(), run_output_names());
    deck.locked = directory();
}

void RunLock::has_begun() {
    earlier_->discard();
}

void RunLock::warn_if_moved() const {
    if (!directory().is_at_its_path()) {
        talk(
            fmt::format("warning: {} was moved or replaced while the run went on: the files of the run are in the "
                        "directory that was moved\n",
                        directory().path().string()));
    }
}

}  // namespace ljmd
