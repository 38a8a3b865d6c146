#include "run/earlier_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "io/files/checkpoint_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

// Three names, so that it is known which run every file belongs to. While files are being moved, those beside the
// folder all belong to the earlier run; when all have been moved, to the new one. When the new run stays, the files in
// the folder are only removed, and never put back in its place.
const std::string moving = ".ljmd-moving";
const std::string aside = ".ljmd-earlier";
const std::string replaced = ".ljmd-replaced";

/// Shows why a run failed. It stays, because the error message names it.
const std::string failure = "failed.xyz";

/// @throws FileError when this cannot be determined: a run must not be removed because its checkpoint was not seen
bool is_there(const OpenDirectory& directory, const std::string& name) {
    struct stat status {};
    if (::fstatat(directory.descriptor(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) {
        return true;
    }
    if (errno != ENOENT) {
        throw FileError(fmt::format("cannot look at '{}': {}", (directory.path() / name).string(),
                                    std::generic_category().message(errno)));
    }
    return false;
}

/// Move a file that may be missing. @return 0 or the error number
int move(const OpenDirectory& from, const std::string& name, const OpenDirectory& to, const std::string& new_name) {
    const bool moved = ::renameat(from.descriptor(), name.c_str(), to.descriptor(), new_name.c_str()) == 0;
    return moved || errno == ENOENT ? 0 : errno;
}

void move_or_throw(const OpenDirectory& from, const std::string& name, const OpenDirectory& to,
                   const std::string& new_name) {
    if (const int error = move(from, name, to, new_name); error != 0) {
        throw FileError(
            fmt::format("cannot move '{}': {}", (from.path() / name).string(), std::generic_category().message(error)));
    }
}

void remove_folder(const OpenDirectory& directory, const std::string& name) {
    ::unlinkat(directory.descriptor(), name.c_str(), AT_REMOVEDIR);
}

/// Move the files from the folder `moving` back; those that cannot be moved stay in it.
void move_back(const OpenDirectory& directory, const std::vector<std::string>& names) {
    const OpenDirectory folder = directory.made_within(moving);
    if (is_there(directory, failure)) {
        ::unlinkat(folder.descriptor(), failure.c_str(), 0);
    }
    for (const std::string& name : names) {
        static_cast<void>(move(folder, name, directory, name));
    }
    directory.sync();
    remove_folder(directory, moving);
}

/// Put the earlier run back from the folder `aside`.
void put_back(const OpenDirectory& directory, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (name != failure) {
            ::unlinkat(directory.descriptor(), name.c_str(), 0);
        }
    }
    move_or_throw(directory, aside, directory, moving);
    directory.sync();
    move_back(directory, names);
}

/// Remove a folder and the files in it; those that cannot be removed stay.
void remove_with_files(const OpenDirectory& directory, const std::string& folder_name,
                       const std::vector<std::string>& names) {
    const OpenDirectory folder = directory.made_within(folder_name);
    for (const std::string& name : names) {
        ::unlinkat(folder.descriptor(), name.c_str(), 0);
    }
    remove_folder(directory, folder_name);
}

void remove_aside(const OpenDirectory& directory, const std::vector<std::string>& names) {
    const bool renamed = move(directory, aside, directory, replaced) == 0;
    remove_with_files(directory, renamed ? replaced : aside, names);
}

}  // namespace

EarlierRun::EarlierRun(OpenDirectory directory, std::vector<std::string> names)
    : directory_(std::move(directory)), names_(std::move(names)) {
    if (std::ranges::none_of(names_, [&](const std::string& name) { return is_there(directory_, name); })) {
        return;
    }
    const OpenDirectory folder = directory_.made_within(moving);
    try {
        for (const std::string& name : names_) {
            move_or_throw(directory_, name, folder, name);
        }
        folder.sync();
        move_or_throw(directory_, moving, directory_, aside);
        aside_ = true;
        directory_.sync();
    } catch (...) {
        aside_ ? put_back(directory_, names_) : move_back(directory_, names_);
        throw;
    }
}

EarlierRun::~EarlierRun() {
    try {
        if (aside_) {
            put_back(directory_, names_);
        }
    } catch (const FileError&) {  // it stays in the folder, for settle_earlier_run()
    }
}

void EarlierRun::discard() {
    if (std::exchange(aside_, false)) {
        remove_aside(directory_, names_);
    }
}

void remove_replaced_run(const OpenDirectory& directory, const std::vector<std::string>& names) {
    if (is_there(directory, replaced)) {
        remove_with_files(directory, replaced, names);
    }
}

bool settle_earlier_run(const OpenDirectory& directory, const std::vector<std::string>& names) {
    remove_replaced_run(directory, names);
    if (is_there(directory, moving)) {
        move_back(directory, names);
        return true;
    }
    if (!is_there(directory, aside)) {
        return false;
    }
    const std::vector<std::string> checkpoints = checkpoint_names();
    if (std::ranges::any_of(checkpoints, [&](const std::string& name) { return is_there(directory, name); })) {
        remove_aside(directory, names);
        return false;
    }
    put_back(directory, names);
    return true;
}

}  // namespace ljmd
