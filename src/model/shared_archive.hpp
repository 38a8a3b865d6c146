#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <vector>

#include "execution/ranks.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"

namespace ljmd {

/// Archives lists that have some numbers for each atom, where the atoms are shared among ranks. The bytes are the same
/// as of one list for all atoms, in the order of the ranks. They pass through rank 0 piece by piece, so that no rank
/// needs room for more than its own part.
class SharedArchive {
  public:
    /// Collective.
    /// @param a      of several ranks, rank 0's is written to
    /// @param here   number of atoms of this rank, of `total`
    SharedArchive(Archive& a, Ranks& ranks, Index here, Index total);

    /// Write the numbers of all ranks. Collective.
    /// @param here  this rank's numbers: `per_atom` for each of its atoms
    template <class T>
    void write(std::span<const T> here, Index per_atom) {
        const std::size_t size = sizeof(T) * static_cast<std::size_t>(per_atom);
        if (ranks_.is_root()) {
            auto count = static_cast<std::uint64_t>(total_ * per_atom);
            archive_(count);
        }
        write_bytes(std::as_bytes(here.first(static_cast<std::size_t>(here_ * per_atom))), size);
    }

    /// Read a list of `per_atom` numbers for each atom. Each rank reads all, and keeps an even share.
    /// @param check  is called with all numbers, in pieces of whole atoms, by every rank
    /// @throws CheckpointError if it has another length
    template <class List, class Check>
    void read(List& list, Index per_atom, const Check& check) {
        using T = typename List::value_type;
        std::uint64_t count = 0;
        archive_(count);
        if (count != static_cast<std::uint64_t>(total_ * per_atom)) {
            throw CheckpointError("some of its atoms lack data");
        }
        if (count > archive_.left() / sizeof(T)) {
            throw CheckpointError("a list is longer than the rest of the file");
        }
        const Share share = even_share(total_, ranks_);
        list.resize(static_cast<std::size_t>(share.count() * per_atom));
        std::vector<T> piece;
        for (Index first = 0; first < total_; first += atoms_of_piece) {
            const Index last = std::min(first + atoms_of_piece, total_);
            piece.resize(static_cast<std::size_t>((last - first) * per_atom));
            archive_.numbers(std::span(piece));
            check(std::span<const T>(piece));
            const Index from = std::max(first, share.first);
            const Index to = std::min(last, share.last);
            if (from < to) {
                std::copy_n(piece.begin() + (from - first) * per_atom, (to - from) * per_atom,
                            list.begin() + (from - share.first) * per_atom);
            }
        }
    }

  private:
    static constexpr Index atoms_of_piece = 1 << 14;

    void write_bytes(std::span<const std::byte> here, std::size_t bytes_per_atom);

    Archive& archive_;
    Ranks& ranks_;
    Index here_;
    Index total_;
    std::vector<std::int64_t> counts_;  // of atoms, for each rank
};

}  // namespace ljmd
