#include "cli/progress.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const Stage production{"production", {"velocity-verlet"}, 0.004, 100, 1.0, true, false, {}};

/// What a run of 100 steps says on stderr when the clock is looked at twice.
std::string said(bool quiet) {
    Captured captured(stderr);
    {
        Progress progress(108, 100, quiet);
        progress.stage_begins(production);
        progress.step_done(55);
        progress.step_done(56);
        progress.warning("a doubt");
    }
    return captured.text();
}

/// stderr is a terminal while this lives.
class Terminal {
  public:
    Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
        if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) {
            return;
        }
        const int slave = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);
        if (slave >= 0) {
            std::fflush(stderr);
            saved_ = ::dup(STDERR_FILENO);
            ::dup2(slave, STDERR_FILENO);
            ::close(slave);
        }
    }
    ~Terminal() {
        restore();
        ::close(master_);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    [[nodiscard]] bool works() const { return saved_ >= 0; }

    /// What was written up to `ending`, or up to the time when nothing has come for ten seconds. The kernel hands on
    /// what is written to a terminal when it finds the time: one read may see a part of it.
    [[nodiscard]] std::string text_up_to(std::string_view ending) {
        constexpr int patience = 10'000;  // [ms]
        std::fflush(stderr);
        std::string text;
        pollfd ready{master_, POLLIN, 0};
        while (!text.ends_with(ending) && ::poll(&ready, 1, patience) > 0) {
            std::array<char, 4096> part;
            const ssize_t length = ::read(master_, part.data(), part.size());
            if (length <= 0) {
                break;
            }
            text.append(part.data(), static_cast<std::size_t>(length));
        }
        restore();
        return text;
    }

  private:
    void restore() {
        if (saved_ >= 0) {
            ::dup2(saved_, STDERR_FILENO);
            ::close(std::exchange(saved_, -1));
        }
    }
    int master_;
    int saved_ = -1;
};

}  // namespace

TEST_CASE("a line of progress has per cent, step, rates and the time that is left") {
    const Captured silenced(stderr);
    Progress progress(864, 25000, false);
    progress.stage_begins(production);
    CHECK(progress.line(10500, 4210.0) ==
          "[production]  42 % step 10500/25000  4.21e+03 steps/s  3.64e+06 atom-steps/s  ETA 0:04");
    CHECK_THAT(progress.line(0, 1.0), StartsWith("[production]   0 % step 0/25000") && EndsWith("ETA 6:56:40"));
    CHECK_THAT(progress.line(25000, 10.0), Contains("100 %") && EndsWith("ETA 0:00"));
    CHECK_THAT(progress.line(24900, 1.0), EndsWith("ETA 1:40"));
}

TEST_CASE("few bodies have neither atoms nor tau") {
    Captured captured(stderr);
    Progress progress(std::nullopt, 25000, false);
    progress.stage_begins(production);
    CHECK(progress.line(10500, 4210.0) == "[production]  42 % step 10500/25000  4.21e+03 steps/s  ETA 0:04");
    CHECK(captured.text() == "stage 'production': 100 steps of 0.004\n");
}

TEST_CASE("a time that cannot be told is a question mark") {
    CHECK_THAT(Progress(864, 100, true).line(0, 0.0), EndsWith("ETA ?"));
    CHECK_THAT(Progress(864, 0, true).line(0, 0.0), Contains("100 %") && EndsWith("ETA ?"));
    CHECK_THAT(Progress(864, Index{1} << 62, true).line(0, 1e-3),
               EndsWith("ETA ?"));  // more seconds than 64 bits count
}

TEST_CASE("on a terminal the line has the present values, and parts are left out until it fits") {
    const Captured silenced(stderr);
    Progress progress(864, 25000, false);
    progress.stage_begins(production);
    Thermodynamics values{};
    values.temperature = 0.71291;
    values.potential_energy = -6.10148;
    values.pressure = 0.0807;
    progress.sampled(ThermoRow{10500, 42.0, values, {}, {}});
    const auto line = [&](std::size_t columns) { return progress.line_within(columns, 10500, 4210.0); };
    CHECK(line(200) ==
          "[production]   42 %  10500/25000  4210 steps/s  3.64e+06 atom-steps/s  ETA 0:04  T 0.7129  U/N -6.101  "
          "p 0.0807");
    CHECK(line(79) == "[production]   42 %  4210 steps/s  ETA 0:04  T 0.7129  U/N -6.101  p 0.0807");
    CHECK(line(70) == "[production]   42 %  4210 steps/s  ETA 0:04  T 0.7129  U/N -6.101");
    CHECK(line(39) == "[production]   42 %  ETA 0:04  T 0.7129");
    CHECK(line(20) == "[production]   42 %");
    CHECK(line(10) == " 42 %");
    CHECK(line(3) == " 42");
    CHECK(line(0).empty());
}

TEST_CASE("before values are left out, a long name of a stage is shortened, and wide characters count twice") {
    const Captured silenced(stderr);
    Progress progress(std::nullopt, 100, false);
    Stage stage = production;
    stage.name = "a stage with a very long name";
    progress.stage_begins(stage);
    progress.sampled(FewBodyRow{50, 0.2, {-0.25, -0.125, -0.375, Vec3::Zero(), Vec3::Zero()}});
    CHECK(progress.line_within(79, 50, 12.5) ==
          "[a stage with a very long name]   50 %  50/100  12 steps/s  ETA 0:04  E -0.375");
    CHECK(progress.line_within(70, 50, 12.5) ==
          "[a stage with a very long name]   50 %  12 steps/s  ETA 0:04  E -0.375");
    CHECK(progress.line_within(60, 50, 12.5) == "[a stage with]   50 %  12 steps/s  ETA 0:04  E -0.375");
    stage.name = "\xE7\x86\x94\xE7\x86\x94\xE7\x86\x94";  // three characters of two columns each
    progress.stage_begins(stage);
    CHECK(progress.line_within(15, 50, 12.5) == "[" + stage.name + "]   50 %");
    CHECK(progress.line_within(14, 50, 12.5) == " 50 %");
}

TEST_CASE("off a terminal there are plain lines, one for each tenth at most") {
    const std::string text = said(false);
    CHECK_THAT(text, StartsWith("stage 'production': 100 steps of 0.004 tau\n[production]  55 % step 55/100  "));
    CHECK_THAT(text, EndsWith("\nwarning: a doubt\n"));
    CHECK(std::count(text.begin(), text.end(), '\n') == 3);
    CHECK(text.find_first_of("\r\033") == std::string::npos);
}

TEST_CASE("doubts are printed like warnings, unless they are left to the report that follows") {
    Captured captured(stderr);
    {
        Progress progress(108, 100, true);
        progress.doubted("a doubt");
        progress.leave_doubts_to_report();
        progress.doubted("another doubt");
        progress.warning("a warning");
    }
    CHECK(captured.text() == "warning: a doubt\nwarning: a warning\n");
}

TEST_CASE("quiet, only warnings are heard") {
    CHECK(said(true) == "warning: a doubt\n");
}

TEST_CASE("on a terminal one line renews itself and makes room for what is said") {
    Terminal terminal;
    if (!terminal.works()) {
        WARN("no pseudo-terminal here: not tested");
        return;
    }
    {
        Progress progress(108, 100, false);
        progress.stage_begins(production);
        progress.step_done(3);
        progress.warning("a doubt");
    }
    const std::string text = terminal.text_up_to("doubt\r\n");
    CHECK_THAT(text, Contains("\r\033[?7l[production]    3 %  3/100"));
    CHECK_THAT(text, EndsWith("\033[J\033[?7h\r\r\033[?7l\033[J\033[?7h\rwarning: a doubt\r\n"));
}
