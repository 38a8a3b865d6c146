#include "ljmd/cli/pages/completion.hpp"

#include <fmt/format.h>

#include <set>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/deck/deck_schema.hpp"
#include "ljmd/options/key_paths.hpp"

namespace ljmd {

std::vector<std::string> all_deck_keys() {
    std::set<std::string> keys;
    for (const DeckKind kind : {DeckKind::fluid, DeckKind::few_body}) {
        for (const KeyPlace& place : key_places(deck_schema(kind))) {
            if (!place.is_table) {
                keys.insert(place.path);
            }
        }
    }
    return {keys.begin(), keys.end()};
}

std::string completion(const CommandTree& tree, const std::string& shell) {
    if (shell == "bash") {
        return bash_completion(tree);
    }
    if (shell == "fish") {
        return fish_completion(tree);
    }
    if (shell == "zsh") {
        return zsh_completion(tree);
    }
    throw InputError(fmt::format("no completion for {}; there is one for bash, fish and zsh", in_quotes(shell)));
}

}  // namespace ljmd
