#pragma once

#include <string>
#include <vector>

#include "benchmarks/decks/deck_model.h"

namespace tricontact::benchmarks {

/// "1, 2.5, 3", twelve digits, lines of about a hundred characters.
std::string number_list(const std::vector<double>& numbers);

/// Every "@name@" of a template replaced by its value; throws std::logic_error where one is left.
struct TemplateValue {
    std::string name, value;
};
std::string filled(std::string text, const std::vector<TemplateValue>& values);

/// What is pressed, for a script's first lines.
std::string body_words(const DeckModel& model);

/// Digits for a script.
std::string number(double value);

}  // namespace tricontact::benchmarks
