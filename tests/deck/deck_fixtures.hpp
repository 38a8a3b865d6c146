#pragma once

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>
#include "catch.hpp"

#include "core/text.hpp"
#include "deck/deck.hpp"
#include "deck/deck_execution.hpp"
#include "deck/fluid.hpp"
#include "deck/sample_decks.hpp"
#include "io/output_fixtures.hpp"

namespace ljmd::test {

inline const std::string argon_table = R"(
[argon]
sigma = "3.405 angstrom"
epsilon = "119.8 K"
mass = "39.948 u"
)";

/// What stands in a text, and what shall stand there instead.
using Replacements = std::vector<std::pair<std::string, std::string>>;

/// The text with each first occurrence replaced. What is to be replaced must be there.
inline std::string changed(std::string text, const Replacements& replacements) {
    for (const auto& [before, after] : replacements) {
        const std::size_t at = text.find(before);
        INFO("replaces: " << before);
        REQUIRE(at != std::string::npos);
        text.replace(at, before.size(), after);
    }
    return text;
}

/// A folder with one deck in it.
class DeckFolder {
  public:
    explicit DeckFolder(const std::string& text = small_deck) : path_(folder_ / "deck.toml") {
        std::ofstream(path_, std::ios::binary) << text;
    }

    [[nodiscard]] const std::filesystem::path& deck_path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

    /// The deck, which must be good. Its output directory is `out` in this folder.
    [[nodiscard]] Deck load(const std::vector<std::string>& settings = {}) const {
        Diagnostics diagnostics;
        auto deck = load_deck(path_, settings, false, diagnostics);
        for (const Diagnostic& entry : diagnostics.entries()) {
            UNSCOPED_INFO(format(entry));
        }
        REQUIRE(deck.has_value());
        deck->directory = folder_ / "out";
        return std::move(*deck);
    }

  private:
    TemporaryFolder folder_;
    std::filesystem::path path_;
};

/// What loading a deck complains of.
inline std::vector<Diagnostic> complaints(const std::string& text, const std::vector<std::string>& settings = {},
                                          bool force = false) {
    const DeckFolder folder(text);
    Diagnostics diagnostics;
    const auto deck = load_deck(folder.deck_path(), settings, force, diagnostics);
    CHECK(deck.has_value() == !diagnostics.has_errors());
    return diagnostics.entries();
}

/// The line of the deck that a complaint points at; the name of the source when it points at no line.
inline std::string line_shown(const Diagnostic& diagnostic) {
    const Location& where = diagnostic.location;
    REQUIRE(where.source != nullptr);
    return where.line > 0 ? std::string(line_of(where.source->text, where.line)) : where.source->name;
}

inline void no_warnings(const std::string& text) {
    FAIL("unexpected warning: " << text);
}

/// The simulation that a deck describes, made without a warning.
inline FluidSystem simulation_of(const Deck& deck) {
    return make_fluid(fluid_spec(deck, find_start(deck)), Execution(execution_options(deck)), no_warnings);
}

/// While it lives, what is written to stdout or stderr goes to a file.
class Captured {
  public:
    explicit Captured(std::FILE* stream) : stream_(stream), file_(std::tmpfile()) {
        REQUIRE(file_ != nullptr);
        std::fflush(stream_);
        saved_ = ::dup(::fileno(stream_));
        REQUIRE(saved_ >= 0);
        REQUIRE(::dup2(::fileno(file_), ::fileno(stream_)) >= 0);
    }
    ~Captured() {
        restore();
        std::fclose(file_);
    }
    Captured(const Captured&) = delete;
    Captured& operator=(const Captured&) = delete;

    /// What was written. The stream is itself again.
    [[nodiscard]] std::string text() {
        restore();
        std::rewind(file_);
        std::string all;
        for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_)) {
            all += static_cast<char>(c);
        }
        return all;
    }

  private:
    void restore() {
        if (saved_ >= 0) {
            std::fflush(stream_);
            ::dup2(saved_, ::fileno(stream_));
            ::close(std::exchange(saved_, -1));
        }
    }

    std::FILE* stream_;
    std::FILE* file_;
    int saved_ = -1;
};

/// What a command says, on both streams.
struct Said {
    std::string out;
    std::string err;
};

template <class Command>
Said said(const Command& command) {
    Captured out(stdout);
    Captured err(stderr);
    command();
    return {out.text(), err.text()};
}

}  // namespace ljmd::test
