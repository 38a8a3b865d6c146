#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/deck.hpp"
#include "ljmd/detail/core/data.hpp"
#include "ljmd/engine/few_body_simulation.hpp"
#include "ljmd/engine/simulation.hpp"

namespace ljmd {

/// The run that a page shows. All that it tells is Data, for the page's script.
class PageRun {
  public:
    /// Of a fluid; more would take a browser's memory, and minutes for a step.
    static constexpr Index most_atoms = 200'000;

    /// @param force  run a deck with unlikely values, too
    /// @param flip   a time [tau] at which one atom is moved by the spacing of the grid on which the bit-reversible
    ///               integrator computes: a flipped bit; negative: none
    /// @throws InputError with the messages that `ljmd run` has for the deck; DataError, PhysicsError as it
    PageRun(const std::string& name, const std::string& text, const std::vector<std::string>& settings, bool force,
            double flip = -1.0);

    /// What is run: kind, title, atoms, edges, stages, units of a substance, warnings about the deck.
    [[nodiscard]] Data description() const;

    /// Take some steps. @return where the run is, and the samples since the last call
    [[nodiscard]] Data advance(Index steps);

    /// The report that `ljmd run` ends with (results.json), and the tables of the analyses, of the run so far.
    [[nodiscard]] Data result() const;

    /// The step, and the checksum of the positions as `ljmd run` prints it.
    [[nodiscard]] Data checksum_data() const;

    /// Speeds of the atoms as they are now: a histogram as a density, and Maxwell's distribution at their temperature.
    [[nodiscard]] Data speeds() const;

    /// The configuration with its velocities as extended XYZ, which a deck can start from.
    [[nodiscard]] std::string configuration() const;

    /// What is drawn: of a fluid the positions as fractions of the edges times 65536, and the speeds as 0 to 255, where
    /// 255 is three times the thermal speed; of few bodies their coordinates.
    void draw();
    [[nodiscard]] const std::vector<std::uint16_t>& drawn_positions() const { return positions_; }
    [[nodiscard]] const std::vector<std::uint8_t>& drawn_speeds() const { return speeds_; }

  private:
    [[nodiscard]] const State& state() const;
    [[nodiscard]] const Stage& present_stage() const;

    Deck deck_;
    std::vector<std::string> warnings_;
    std::optional<std::variant<Simulation, FewBodySimulation>> run_;
    std::size_t told_ = 0;  ///< samples that were passed on
    std::vector<std::uint16_t> positions_;
    std::vector<std::uint8_t> speeds_;
};

}  // namespace ljmd
