#include "app/new_case/first_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "contact/base/error.h"
#include "contact/models/model_kind.h"
#include "io/case/case_reader.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::app {

namespace {

constexpr const char* none = "none";
constexpr const char* answer_name = "answer";  // of the file, in messages
constexpr const char *title_key = "title", *models_key = "models",
                     *thickness_key = "substrate.thickness",
                     *amplitude_key = "rolling.amplitude_ratio";

constexpr std::array<Question, 10> questions{
    {{title_key, "Title", "A first case"},
     {"indenter.radius", "Radius of the ball", "40 mm"},
     {"substrate.young", "Young's modulus of the substrate", "5.2 MPa"},
     {"substrate.poisson", "Its Poisson's ratio", "0.5"},
     {thickness_key, "Its thickness; none: a half-space", none, true},
     {"friction.coefficient", "Coefficient of friction", "0.5"},
     {"load.normal_force", "Normal force", "20 N"},
     {"load.tangential_ratio", "Tangential force over friction times normal force, 0 to 1", "0.3"},
     {amplitude_key, "Amplitude of rolling over the contact radius; none: no rolling", "0.2", true},
     {models_key, "Models, of those that tricontact list names", ""}}};

/// What follows the place that a message begins with: `name:line:column: `.
std::string without_place(const std::string& message, const std::string& name) {
    if (!message.starts_with(name + ':')) return message;
    const std::size_t end = message.find(": ");
    return end == std::string::npos ? message : message.substr(end + 2);
}

/// "mdr, bem" and ["mdr", "bem"] as a list of TOML.
std::string list_of_words(std::string text) {
    std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == '"' || c == ' '; });
    std::string list;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        list += (list.empty() ? "" : ", ") + io::toml_string(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return '[' + list + ']';
}

std::string without_quotes(const std::string& text) {
    const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::span<const Question> first_questions() {
    return questions;
}

std::string FirstCase::usual(const Question& question) const {
    if (question.key != std::string(models_key)) return question.usual;
    using namespace contact::models;
    const std::string elements =
        std::string(bem) + (given(thickness_key) != none ? std::string(",") + bem_layer : "");
    // Springs are left out where they would refuse the materials: coupled contact.
    FirstCase all = *this;
    all.answers_[models_key] = std::string(mdr) + ',' + elements;
    try {
        io::parse_case(all.text(), answer_name);
        return all.answers_[models_key];
    } catch (const contact::InputError&) {
        return elements;
    }
}

std::string FirstCase::given(const std::string& key) const {
    const auto found = answers_.find(key);
    if (found != answers_.end()) return found->second;
    return usual(
        *std::ranges::find(questions, key, [](const Question& q) { return std::string(q.key); }));
}

std::string FirstCase::value(const std::string& key) const {
    const std::string text = without_quotes(given(key));
    if (key == models_key) return list_of_words(given(key));
    if (key != title_key && io::number_in(text)) return text;
    return io::toml_string(text);
}

void FirstCase::answer(const Question& question, const std::string& answer) {
    const std::map<std::string, std::string> before = answers_;
    const std::string text(io::trimmed(answer));
    answers_[question.key] = text.empty() ? usual(question) : text;
    try {
        if (text == none && !question.may_be_none)
            io::fail("", question.key, "is needed", "for example " + usual(question));
        io::parse_case(this->text(), answer_name);
    } catch (const contact::InputError& error) {
        answers_ = before;
        throw contact::InputError(without_place(error.what(), answer_name));
    }
}

std::string FirstCase::text() const {
    const auto line = [&](const char* key, const char* comment = "") {
        const std::string name(key), last = name.substr(name.rfind('.') + 1);
        const std::string text = fmt::format("{} = {}", last, value(key));
        return *comment ? fmt::format("{:<31} # {}\n", text, comment) : text + '\n';
    };
    const bool layer = given(thickness_key) != none, rolls = given(amplitude_key) != none;
    std::string text = line(title_key) + line(models_key, "side by side, from the same case") +
                       "[indenter]\n" + line("indenter.radius", "rigid; young, poisson: elastic") +
                       "[substrate]\n" + line("substrate.young") + line("substrate.poisson");
    if (layer) text += line(thickness_key, "on a rigid base");
    text += "[friction]\n" + line("friction.coefficient") + "[load]\n" + line("load.normal_force") +
            line("load.tangential_ratio", "F_T/(mu F_N); or tangential_force");
    if (rolls) text += "[rolling]\n" + line(amplitude_key, "W over the contact radius");
    if (rolls && layer) text += "amplitude_reference = \"model\"   # each model's own\n";
    return text + fmt::format("[bem]\n{:<31} # coarse: seconds; 22 for results\n",
                              "cells_per_radius = 10");
}

}  // namespace tricontact::app
