#include "ljmd/detail/run/interruption.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/files/shell_word.hpp"

namespace ljmd {

namespace {

constexpr int walltime_reached = 75;  // EX_TEMPFAIL: try again later

}  // namespace

int StopRequest::exit_code() const {
    constexpr int base = 128;
    return base + signal;
}

Interruption::Interruption(std::optional<double> walltime, AskedToStop asked) : asked_(std::move(asked)) {
    if (walltime) {
        end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*walltime));
    }
}

void Interruption::stop(Index step, const std::string& directory) const {
    const auto by = request();
    throw Interrupted(fmt::format("stopped after step {} by {}; to go on: ljmd resume {}", step,
                                  by ? by->name : std::string("the end of its wall time"), shell_word(directory)),
                      by ? by->exit_code() : walltime_reached);
}

void Interruption::stop_many_runs() const {
    const auto by = request();
    if (!by && !time_is_over()) {
        throw ContractViolation("nothing has asked the runs to stop");
    }
    throw Interrupted("stopped; to go on, give the same command again", by ? by->exit_code() : walltime_reached);
}

}  // namespace ljmd
