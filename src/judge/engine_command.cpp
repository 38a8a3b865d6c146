#include "judge/engine_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "core/text.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/process.hpp"
#include "io/files/shell_word.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_printed = std::uintmax_t{64} << 20U;  // bytes

/// Whether a place in a command of the shell is within quotes.
bool is_within_quotes(const std::string& command, std::size_t place) {
    char open = '\0';
    for (std::size_t k = 0; k < place; ++k) {
        const char c = command[k];
        if (open == '\0' && (c == '\'' || c == '"')) {
            open = c;
        } else if (c == open) {
            open = '\0';
        } else if (c == '\\' && open != '\'') {
            ++k;
        }
    }
    return open != '\0';
}

/// Refuse a command that lacks a name, or quotes it. @throws InputError
void check_name(const std::string& command, const std::string& name, const char* meaning) {
    std::size_t place = command.find(name);
    if (place == std::string::npos) {
        throw InputError(
            fmt::format("--with command: {} is missing, {}; as in './engine {{input}} {{output}}'", name, meaning));
    }
    for (; place != std::string::npos; place = command.find(name, place + name.size())) {
        if (is_within_quotes(command, place)) {
            throw InputError(fmt::format("--with command: {} stands within quotes; ljmd quotes it itself", name));
        }
    }
}

/// The last lines that an engine has printed, for a message; empty if it has printed nothing.
std::string last_words(const fs::path& log) {
    constexpr std::size_t lines = 6;
    constexpr std::streamoff enough = 4096;
    constexpr std::size_t longest = 160;
    std::ifstream file = open_input(log);
    file.seekg(0, std::ios::end);
    file.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(file.tellg()) - enough));
    std::vector<std::string> last;
    for (std::string line; std::getline(file, line);) {
        if (!line.empty()) {
            last.push_back(printable(line, longest));
        }
    }
    last.erase(last.begin(), last.end() - static_cast<std::ptrdiff_t>(std::min(last.size(), lines)));
    std::string words;
    for (const std::string& line : last) {
        words += "\n  " + line;
    }
    return words.empty() ? "; it has printed nothing" : "; the last that it has printed:" + words;
}

/// Bytes of the files in a folder and in those within it. What cannot be looked at, or is removed meanwhile, does not
/// count.
std::uintmax_t bytes_within(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    try {
        for (const fs::path& entry : files::list(folder)) {
            const fs::file_type type = files::type_of(entry);
            bytes += type == fs::file_type::regular     ? files::size_of(entry).value_or(0)
                     : type == fs::file_type::directory ? bytes_within(entry)
                                                        : 0;
        }
    } catch (const FileError&) {
    }
    return bytes;
}

}  // namespace

std::string engine_command(const std::string& command, const fs::path& input, const fs::path& output) {
    const std::string input_name = "{input}";
    const std::string output_name = "{output}";
    check_name(command, input_name, "the directory with the problem");
    check_name(command, output_name, "the directory that the answer is written to");
    std::string line;
    for (std::size_t k = 0; k < command.size();) {
        const bool is_input = command.compare(k, input_name.size(), input_name) == 0;
        if (is_input || command.compare(k, output_name.size(), output_name) == 0) {
            line += shell_word(is_input ? input : output);
            k += is_input ? input_name.size() : output_name.size();
        } else {
            line += command[k++];
        }
    }
    return line;
}

void run_engine(const std::string& command, const fs::path& log, const EngineLimits& limits,
                const Interruption& interruption) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(limits.seconds);
    ChildProcess engine(
        {.program = "/bin/sh", .arguments = {"-c", command}, .directory = ".", .output = log, .kept = true});
    std::string excess;
    const auto goes_too_far = [&] {
        if (files::size_of(log).value_or(0) > most_printed) {
            excess = fmt::format("it prints more than {} MiB, which nobody reads", most_printed >> 20U);
        } else if (!limits.folder.empty() && bytes_within(limits.folder) > limits.written) {
            excess = fmt::format("it has written more than {:.3g} GB, which nobody reads",
                                 static_cast<double>(limits.written) * 1e-9);
        } else if (Clock::now() >= end) {
            excess = "it takes longer than --timeout allows";
        }
        return !excess.empty();
    };
    const std::optional<int> status = engine.wait_while([&] { return !interruption.request() && !goes_too_far(); });
    if (!status) {
        engine.stop();
        if (interruption.request()) {
            interruption.stop_many_runs();
        }
        throw DataError(fmt::format("the engine was stopped{}: {}{}",
                                    Clock::now() >= end ? fmt::format(" after {:g} s", limits.seconds) : "", excess,
                                    last_words(log)));
    }
    if (*status != 0) {
        constexpr int signals_from = 128;
        throw DataError(fmt::format("the engine failed: {}{}",
                                    *status > signals_from ? fmt::format("signal {} ended it", *status - signals_from)
                                                           : fmt::format("exit status {}", *status),
                                    last_words(log)));
    }
}

}  // namespace ljmd
