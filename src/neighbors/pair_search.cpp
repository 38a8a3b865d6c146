#include "neighbors/pair_search.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"

namespace ljmd {

std::vector<std::string> pair_search_names() {
    return {std::string(VerletList::name), std::string(LinkedCells::name), std::string(AllPairs::name)};
}

PairSearch make_pair_search(const std::string& name, double skin, std::optional<Index> every,
                            std::optional<Index> tile) {
    if (name == VerletList::name) {
        return VerletList(skin, every, tile);
    }
    if (name == LinkedCells::name) {
        return LinkedCells();
    }
    if (name == AllPairs::name) {
        return AllPairs();
    }
    throw InputError(fmt::format("unknown pair search '{}', allowed: verlet-list, cells, all-pairs", name));
}

}  // namespace ljmd
