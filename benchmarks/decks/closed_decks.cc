#include "benchmarks/decks/closed_decks.h"

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_texts.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

struct ClosedDeck {
    const char* name;
    std::vector<DeckFile> (*write)(const DeckWishes& wishes);
};
constexpr ClosedDeck closed_decks[]{{"patch_test", patch_test_deck},
                                    {"wedge", wedge_deck},
                                    {"complete_punch", complete_punch_deck},
                                    {"rounded_punch_plane", rounded_punch_plane_deck},
                                    {"pin_in_hole", pin_in_hole_deck},
                                    {"receding_layer", receding_layer_deck},
                                    {"nafems_roller", nafems_roller_deck},
                                    {"nafems_punch", nafems_punch_deck},
                                    {"complete_punch_two_bodies", complete_punch_two_bodies_deck}};

const ClosedDeck* find_deck(std::string_view problem) {
    for (const ClosedDeck& deck : closed_decks)
        if (problem == deck.name) return &deck;
    return nullptr;
}

}  // namespace

bool has_closed_deck(std::string_view problem) {
    return find_deck(problem) != nullptr;
}

std::vector<DeckFile> write_closed_deck(const DeckWishes& wishes) {
    const ClosedDeck* deck = find_deck(wishes.problem);
    if (!deck) {
        std::string names;
        for (const ClosedDeck& one : closed_decks)
            names += (names.empty() ? "" : ", ") + std::string(one.name);
        throw contact::InputError("deck: " + wishes.problem +
                                  " has no deck of its own; choose of " + names);
    }
    return deck->write(wishes);
}

}  // namespace tricontact::benchmarks
