#include "cli/pages/man_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace ljmd {

namespace {

/// Text as roff takes it: no escapes, no line that is a request, and a hyphen that can be typed.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
            out += "\\&";
        }
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return out;
}

std::string bold(const std::string& text) {
    return fmt::format("\\fB{}\\fR", roff(text));
}

std::string italic(const std::string& text) {
    return fmt::format("\\fI{}\\fR", roff(text));
}

/// "RUNDIR", "[FILE]", "[ANALYSIS ...]"
std::string argument_in_synopsis(const CommandOption& option) {
    const std::string text = italic(option.value) + (option.many ? " ..." : "");
    return option.required ? text : fmt::format("[{}]", text);
}

/// "--out DIR", "-h, --help"
std::string option_in_list(const CommandOption& option) {
    std::vector<std::string> names;
    std::ranges::transform(option.names, std::back_inserter(names), bold);
    const std::string value = option.value.empty() ? "" : " " + italic(option.value);
    return fmt::format("{}{}", fmt::join(names, ", "), value);
}

std::string items(const std::vector<CommandOption>& options) {
    std::string text;
    for (const CommandOption& option : options) {
        text += fmt::format(".TP\n{}\n{}\n", option.is_argument() ? italic(option.value) : option_in_list(option),
                            roff(option.meaning));
    }
    return text;
}

std::string section(const DescribedCommand& command) {
    std::string synopsis = bold("ljmd " + command.name);
    for (const CommandOption& argument : command.arguments()) {
        synopsis += " " + argument_in_synopsis(argument);
    }
    return fmt::format(".SS {}\n{} [{}]\n.PP\n{}.\n{}{}", roff(command.name), synopsis, italic("OPTIONS"),
                       roff(command.meaning), items(command.arguments()), items(command.named_options()));
}

std::string in_capitals(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

constexpr const char* rest = R"(.SH EXIT STATUS
.TP
0
success
.TP
1
a bug in ljmd
.TP
2
usage, or a mistake in a deck
.TP
3
input data
.TP
4
output could not be written
.TP
5
physics: a run blew up, or a check failed
.TP
6
checkpoint
.TP
7
no memory, threads or processes
.TP
9
the directory is in use
.TP
75
the wall time is over; a checkpoint was written
.TP
128 + n
signal n; a checkpoint was written
.SH ENVIRONMENT
.TP
.B OMP_NUM_THREADS
number of threads where
.B \-\-threads
does not say
.TP
.B LJMD_SIMD
instruction set of the kernels where
.B \-\-simd
does not say
.SH EXAMPLES
.TP
.B ljmd init
write a first deck, first.toml
.TP
.B ljmd check first.toml
find its mistakes, and estimate its cost
.TP
.B ljmd run first.toml \-\-set system.temperature=1.5 \-\-out hotter
run it at another temperature
.TP
.B ljmd resume hotter \-\-steps +2000
make the run longer
)";

}  // namespace

std::string man_page(const CommandTree& tree) {
    const std::string& name = tree.program.name;
    std::string text =
        fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n", in_capitals(name), roff(name), roff(tree.version));
    text += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(tree.program.meaning));
    text += fmt::format(".SH SYNOPSIS\n{} {} [{}]\n", bold(name), italic("COMMAND"), italic("OPTIONS"));
    text += fmt::format(".SH OPTIONS\n{}.SH COMMANDS\n", items(tree.program.named_options()));
    for (const DescribedCommand& command : tree.commands) {
        text += section(command);
    }
    return text + rest;
}

}  // namespace ljmd
