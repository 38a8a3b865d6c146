#include "ljmd/deck/deck_system.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/deck_sense.hpp"
#include "ljmd/deck/few_body.hpp"

namespace ljmd {

namespace {

bool is_fluid(const Deck& deck) {
    return deck.kind() == DeckKind::fluid;
}

void require(bool met, const std::string& otherwise) {
    if (!met) {
        throw InputError(otherwise);
    }
}

}  // namespace

AnySystem make_system(const Deck& deck, std::optional<Start> start, const Execution& execution,
                      const std::function<void(const std::string&)>& warn) {
    if (start) {
        return make_fluid(fluid_spec(deck, std::move(*start)), execution, warn);
    }
    return make_few_body_system(deck, execution);
}

AnySystem empty_system(const Deck& deck, Index atoms, const Vec3& edges, const Execution& execution) {
    if (is_fluid(deck)) {
        return empty_fluid(fluid_spec(deck), atoms, Box(edges), execution);
    }
    return make_few_body_system(deck, execution);
}

bool is_possible_box(const Deck& deck, Index atoms, const Vec3& edges) {
    if (!is_fluid(deck)) {
        return true;
    }
    try {
        Diagnostics diagnostics;
        check_box(deck.fluid(), atoms, Box(edges), diagnostics);
        return !diagnostics.has_errors();
    } catch (const InputError&) {  // no box has these edges
        return false;
    }
}

std::string kind_name(const Deck& deck) {
    return is_fluid(deck) ? "fluid" : "few-body";
}

void require_fluid(const Deck& deck, const std::string& otherwise) {
    require(is_fluid(deck), otherwise);
}

void require_few_bodies(const Deck& deck, const std::string& otherwise) {
    require(!is_fluid(deck), otherwise);
}

std::optional<std::filesystem::path> start_file(const Deck& deck) {
    return is_fluid(deck) && deck.system().file ? std::optional(configuration_file(*deck.system().file)) : std::nullopt;
}

}  // namespace ljmd
