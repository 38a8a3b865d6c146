#pragma once

#include <string>

#include "engine/tables/potential_table.hpp"
#include "engine/tables/system_table.hpp"
#include "options/placed.hpp"

namespace ljmd {

// The keys of a deck that mistakes name, by the members that they stand for.

template <class Member, class Owner>
[[nodiscard]] std::string key(Member Owner::*member) {
    return Placed<Owner>::key(member);
}

/// Of [potential], which has the members of a Cutoff, too.
template <class Member, class Owner>
[[nodiscard]] std::string potential_key(Member Owner::*member) {
    return Placed<PotentialTable>::key(member);
}

template <class Member>
[[nodiscard]] std::string lattice_key(Member LatticeTable::*member) {
    return key(&SystemTable::lattice) + "." + key(member);
}

/// The name of a plug-in in a table of its own.
[[nodiscard]] inline std::string type_key(std::optional<Choice> Stage::*member) {
    return key(member) + "." + plugin_key;
}

}  // namespace ljmd
