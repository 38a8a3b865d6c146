#include "model/shared_archive.hpp"

namespace ljmd {

SharedArchive::SharedArchive(Archive& a, Ranks& ranks, Index here, Index total)
    : archive_(a), ranks_(ranks), here_(here), total_(total), counts_(static_cast<std::size_t>(ranks.size()), 0) {
    if (!a.reading()) {
        counts_[static_cast<std::size_t>(ranks.rank())] = here;
        ranks.sum(counts_);
    }
}

void SharedArchive::write_bytes(std::span<const std::byte> here, std::size_t bytes_per_atom) {
    if (ranks_.is_root()) {
        archive_.numbers(std::span(reinterpret_cast<const char*>(here.data()), here.size()));
    }
    std::vector<double> message;  // the bytes of a piece, and perhaps some more
    for (int rank = 1; rank < ranks_.size(); ++rank) {
        const Index atoms = counts_[static_cast<std::size_t>(rank)];
        for (Index first = 0; first < atoms; first += atoms_of_piece) {
            const auto done = static_cast<std::size_t>(first) * bytes_per_atom;
            const std::size_t bytes =
                static_cast<std::size_t>(std::min(atoms_of_piece, atoms - first)) * bytes_per_atom;
            message.resize((bytes + sizeof(double) - 1) / sizeof(double));
            if (ranks_.is_root()) {
                const Ranks::Incoming incoming{rank, message};
                ranks_.exchange({}, {&incoming, 1});
                archive_.numbers(std::span(reinterpret_cast<char*>(message.data()), bytes));
            } else if (ranks_.rank() == rank) {
                std::memcpy(message.data(), here.data() + done, bytes);
                const Ranks::Outgoing outgoing{0, message};
                ranks_.exchange({&outgoing, 1}, {});
            } else {
                ranks_.exchange({}, {});
            }
        }
    }
}

}  // namespace ljmd
