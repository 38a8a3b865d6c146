#include "ljmd/deck/deck_system.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/deck_sense.hpp"
#include "ljmd/deck/few_body.hpp"
#include "ljmd/engine/mistakes.hpp"

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

FluidSpec with(const std::shared_ptr<ExternalForce>& external, FluidSpec spec) {
    spec.external = external;
    for (const Mistake& mistake : external_force_mistakes(spec)) {
        throw InputError(in_words(mistake));
    }
    return spec;
}

void require_none(const std::shared_ptr<ExternalForce>& external) {
    require(!external, "external forces are for fluids: this deck has few bodies");
}

}  // namespace

AnySystem make_system(const Deck& deck, std::optional<Start> start, const Execution& execution,
                      const std::function<void(const std::string&)>& warn,
                      const std::shared_ptr<ExternalForce>& external) {
    if (start) {
        return make_fluid(with(external, fluid_spec(deck, std::move(*start))), execution, warn);
    }
    require_none(external);
    return make_few_body_system(deck, execution);
}

AnySystem empty_system(const Deck& deck, Index atoms, const Vec3& edges, const Execution& execution,
                       const std::shared_ptr<ExternalForce>& external) {
    if (is_fluid(deck)) {
        return empty_fluid(with(external, fluid_spec(deck)), atoms, Box(edges), execution);
    }
    require_none(external);
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
