#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fuzz_target.hpp"
#include "fuzzed_decks.hpp"
#include "io/files/replacement_file.hpp"
#include "io/files/scratch_directory.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run.hpp"
#include "run/run_directory.hpp"

/// Going on from a checkpoint whose checksum is right, whatever it holds. Inputs are the contents of checkpoints.
namespace ljmd::fuzz {

struct Quiet : RunListener {};

/// A deck that is good, with an output directory of its own.
class RunFolder {
  public:
    explicit RunFolder(const FuzzedDeck& fuzzed) : deck_(load(fuzzed)) { deck_.directory = folder_.path() / "run"; }

    [[nodiscard]] const Deck& deck() const { return deck_; }

    /// Let there be a run that has written enough, and nothing else.
    void prepare() const {
        constexpr std::size_t enough = 4096;
        prepare_directory(deck_.directory);
        for (const char* name : {"thermo.csv", "trajectory.xyz", "trajectory.csv"}) {
            write_file_atomically(deck_.directory / name, std::string(enough, '\n'));
        }
    }

  private:
    static Deck load(const FuzzedDeck& fuzzed) {
        Diagnostics diagnostics;
        auto deck = load_deck_text("deck.toml", fuzzed.text, fuzzed.settings, false, diagnostics);
        diagnostics.throw_if_errors();
        return std::move(*deck);
    }

    ScratchDirectory folder_;
    Deck deck_;
};

/// The content of a checkpoint in its two parts.
struct CheckpointContent {
    CheckpointHead head;
    std::span<const std::byte> rest;  ///< the run's own

    explicit CheckpointContent(std::span<const std::byte> whole) {
        Archive once(whole);
        once(head);
        Archive again;
        again(head);
        rest = whole.subspan(again.bytes().size());
    }
};

/// The checkpoint as the newest one of that deck's run. Version and deck are made to be right: what is refused for
/// these is not looked at any further.
inline Continuation found_again(const RunFolder& folder, CheckpointContent content) {
    const Deck& deck = folder.deck();
    content.head.version = build_info().version;
    content.head.deck_hash = deck_hash(deck);
    folder.prepare();
    CheckpointStore(deck.directory, 1).write([&content](Archive& a) {
        a(content.head);
        a.numbers(std::span(reinterpret_cast<const char*>(content.rest.data()), content.rest.size()));
    });
    return find_continuation(deck).value();
}

}  // namespace ljmd::fuzz
