#pragma once

#include <array>
#include <vector>

#include "ljmd/detail/model/state.hpp"
#include "neighbors/pair_visit.hpp"

namespace ljmd {

/// Copies of the atoms of other ranks that are near the own ones. They are the ghosts of the state. Each rank sends the
/// positions of some atoms to others at every evaluation of the forces; which, and in what order, is agreed when a list
/// is built.
class Halo {
  public:
    /// Send the positions of these atoms to a rank, in this order.
    void send(int to, std::vector<AtomRange> atoms);
    /// Expect as many positions from a rank; they are the ghosts after the ones of the ranks before.
    void receive(int from, Index atoms);
    void clear();

    /// Bring the positions of the ghosts up to date. Collective. @pre state has as many ghosts as are received
    void refresh(State& state) {
        begin_refresh(state);
        finish_refresh(state.execution().ranks());
    }
    /// Send and ask for positions, see Ranks::begin_exchange().
    void begin_refresh(State& state);
    /// Wait for what begin_refresh() has asked for, if anything is under way.
    void finish_refresh(Ranks& ranks);

    /// Pass on what was found for ghosts to the ranks that have the atoms. Collective.
    struct OnAtom {
        Index atom;  ///< of the state; in what is passed on, a ghost, numbered from 0
        std::array<double, 3> force;
    };
    /// @return what each rank has found for the atoms here, in the order in which it was passed on
    [[nodiscard]] std::vector<std::vector<OnAtom>> return_forces(Ranks& ranks,
                                                                 const std::vector<OnAtom>& on_ghosts) const;

    struct Sent {
        int to;
        std::vector<AtomRange> atoms;
        std::vector<double> positions;  ///< buffer of the message
    };
    struct Received {
        int from;
        AtomRange ghosts;  ///< numbered from 0
    };
    [[nodiscard]] const std::vector<Sent>& sent() const { return sent_; }
    [[nodiscard]] const std::vector<Received>& received() const { return received_; }
    /// Number of ghosts.
    [[nodiscard]] Index count() const { return received_.empty() ? 0 : received_.back().ghosts.last; }

  private:
    std::vector<Sent> sent_;
    std::vector<Received> received_;
    bool under_way_ = false;
};

}  // namespace ljmd
