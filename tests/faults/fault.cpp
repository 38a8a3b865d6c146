#include "fault.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace ljmd::faults {

struct NamedError {
    const char* name;
    int number;
    unsigned kinds;  ///< a set
};

namespace {

thread_local bool is_ours = false;  // what is called now

struct Ours {
    Ours() { is_ours = true; }
    ~Ours() { is_ours = false; }
    Ours(const Ours&) = delete;
    Ours& operator=(const Ours&) = delete;
};

using K = Kind;

/// One bit each. Constants all of them, as calls are met before and after the life of any object.
template <class... Kinds>
constexpr unsigned set_of(Kinds... kinds) {
    return ((1U << static_cast<unsigned>(kinds)) | ...);
}

bool is_in(unsigned set, Kind kind) {
    return (set & set_of(kind)) != 0;
}

constexpr unsigned moving_bytes = set_of(K::read, K::write);
constexpr unsigned changing_files =
    set_of(K::create, K::write, K::sync, K::truncate, K::rename, K::remove, K::mkdir, K::link);

/// With the kinds of calls that may end with them, as the manual pages have it.
constexpr std::array<NamedError, 7> errors{
    {{"EIO", EIO, ~set_of(K::lock, K::spawn)},
     {"look", EIO, set_of(K::stat)},
     {"EINTR", EINTR, moving_bytes | set_of(K::open, K::create, K::sync, K::close, K::truncate, K::lock)},
     {"ENOSPC", ENOSPC, set_of(K::create, K::write, K::sync, K::close, K::rename, K::mkdir, K::link)},
     {"EACCES", EACCES, set_of(K::open, K::create, K::rename, K::remove, K::mkdir, K::link, K::stat, K::lookup)},
     {"EMFILE", EMFILE, set_of(K::open, K::create)},
     {"EAGAIN", EAGAIN, set_of(K::spawn)}}};

}  // namespace

Fault* fault() {
    if (is_ours) {
        return nullptr;
    }
    static Fault the_one;
    return &the_one;
}

[[maybe_unused]] const Fault* const made_at_load = fault();

Fault::Fault() {
    const Ours ours;
    const char* text = std::getenv("LJMD_FAULT");
    if (text == nullptr) {
        return;
    }
    const char* rest = std::strchr(text, ':');
    if (rest == nullptr) {
        std::abort();
    }
    const std::string name(text, rest);
    file_ = rest + 1;
    at_ = std::atol(rest + 1);
    const auto error = std::find_if(errors.begin(), errors.end(), [&](const auto& one) { return one.name == name; });
    if (error != errors.end()) {
        mode_ = Mode::error;
        error_ = &*error;
    } else {
        mode_ = name == "kill"    ? Mode::kill
                : name == "tear"  ? Mode::tear
                : name == "full"  ? Mode::full
                : name == "late"  ? Mode::late
                : name == "clock" ? Mode::clock
                : name == "count" ? Mode::count
                : name == "short" ? Mode::cut_short
                                  : Mode::cut;
    }
    if (mode_ == Mode::cut) {
        left_ = name == "none" ? Disk::Rest::none : name == "blocks" ? Disk::Rest::blocks : Disk::Rest::names;
        disk_.emplace(std::getenv("LJMD_FAULT_FOLDER"));
    }
    unsetenv("LJMD_FAULT");
}

Fault::~Fault() {
    const Ours ours;
    if (mode_ != Mode::count) {
        return;
    }
    std::FILE* out = std::fopen(file_.c_str(), "w");
    const auto print = [&](const char* name, unsigned kinds) {
        long calls = 0;
        for (std::size_t kind = 0; kind < kind_names.size(); ++kind) {
            calls += is_in(kinds, static_cast<Kind>(kind)) ? calls_of_kind_.at(kind).load() : 0;
        }
        std::fprintf(out, "%s %ld\n", name, calls);
    };
    for (std::size_t kind = 0; kind < kind_names.size(); ++kind) {
        print(kind_names.at(kind), set_of(kind));
    }
    print("changes", changing_files);
    print("short", moving_bytes);
    for (const NamedError& error : errors) {
        print(error.name, error.kinds);
    }
    std::fclose(out);
}

Fate Fault::next(Kind kind) {
    ++calls_of_kind_.at(static_cast<std::size_t>(kind));
    switch (mode_) {
        case Mode::error:
            if (is_in(error_->kinds, kind) && ++calls_ == at_) {
                errno = error_->number;
                return Fate::fails;
            }
            return Fate::goes_on;
        case Mode::cut_short:
            return is_in(moving_bytes, kind) && ++calls_ == at_ ? Fate::is_short : Fate::goes_on;
        case Mode::kill:
        case Mode::tear:
        case Mode::full:
        case Mode::cut:
            return is_in(changing_files, kind) ? next_change(kind) : Fate::goes_on;
        default:
            return Fate::goes_on;
    }
}

Fate Fault::next_change(Kind kind) {
    const bool takes_space = kind == Kind::write || kind == Kind::create;
    if (mode_ == Mode::cut && takes_space) {  // does not change what is on the disk
        return Fate::goes_on;
    }
    const long number = ++calls_;
    if (mode_ == Mode::cut && number == at_) {
        const Ours ours;
        disk_->cut(left_, static_cast<std::uint64_t>(number));
        std::raise(SIGKILL);
    }
    if ((mode_ == Mode::kill || (mode_ == Mode::tear && kind != Kind::write)) && number == at_) {
        std::raise(SIGKILL);
    }
    if (mode_ == Mode::tear && number == at_) {
        return Fate::torn;
    }
    if (mode_ == Mode::full && number >= at_ && (takes_space || kind == Kind::mkdir)) {
        errno = ENOSPC;
        return Fate::fails;
    }
    return Fate::goes_on;
}

bool Fault::is_too_late() {
    if (mode_ != Mode::late || ++times_ < at_) {
        return false;
    }
    errno = ENOSPC;
    return true;
}

void Fault::synced(int descriptor) {
    const Ours ours;
    if (disk_) {
        disk_->synced(descriptor);
    }
}

long Fault::clock_jump() {
    return mode_ != Mode::clock ? 0 : ++times_ % 2 == 0 ? at_ : -at_;
}

}  // namespace ljmd::faults
