#include "run/run_lock.hpp"

#include <fmt/format.h>

#include <utility>

#include "ljmd/core/errors.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

namespace {

const std::filesystem::path& made(const std::filesystem::path& directory) {
    make_directory(directory);
    return directory;
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& directory, Warn warn) : lock_(directory), warn_(std::move(warn)) {
    if (settle_earlier_run(lock_.directory(), run_output_names())) {
        warn_(fmt::format("the earlier run in {} was put back: the one that was to replace it had no checkpoint yet",
                          directory.string()));
    }
}

RunLock::RunLock(RunPlan& plan, bool force, Warn warn) : RunLock(made(plan.directory), std::move(warn)) {
    check_directory(plan, force);  // again, because another run may have finished in it since
    directory().require_at_its_path();
    earlier_.emplace(directory(), run_output_names());
    plan.locked = directory();
}

RunLock::~RunLock() {
    try {
        remove_replaced_run(directory(), run_output_names());
    } catch (const FileError&) {  // the next command that locks the directory tries again
    }
}

void RunLock::has_begun() {
    earlier_->discard();
    begun_ = true;
}

void RunLock::warn_if_moved() const {
    if (!directory().is_at_its_path()) {
        warn_(
            fmt::format("{} was moved or replaced during the run: the files of the run are in the directory "
                        "that was moved",
                        directory().path().string()));
    }
}

}  // namespace ljmd
