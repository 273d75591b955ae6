#include "benchmarks/decks/script_text.h"

#include <fmt/format.h>

#include <stdexcept>

namespace tricontact::benchmarks {

std::string number(double value) {
    return fmt::format("{:.12g}", value);
}

std::string number_list(const std::vector<double>& numbers) {
    std::string text;
    std::size_t line = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0) text += ", ";
        if (text.size() - line > 85) {
            text += "\n    ";
            line = text.size();
        }
        text += number(numbers[i]);
    }
    return text;
}

std::string body_words(const DeckModel& model) {
    if (model.round_radius == 0) return "Rigid indenter on an elastic block bonded to a rigid base";
    const std::string body = model.shape == DeckModel::Shape::plane ? "cylinder" : "ball";
    return "Rigid plane on the upper half of an elastic " + body +
           (model.has_sliding_base ? ", whose middle plane stays a plane"
                                   : ", its flat face bonded to a rigid holder");
}

std::string filled(std::string text, const std::vector<TemplateValue>& values) {
    for (const auto& [name, value] : values) {
        const std::string mark = "@" + name + "@";
        for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;
             at += value.size())
            text.replace(at, mark.size(), value);
    }
    if (text.find('@') != std::string::npos)
        throw std::logic_error("a script of a deck has a mark that nothing fills: " +
                               text.substr(text.find('@'), 20));
    return text;
}

}  // namespace tricontact::benchmarks
