#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tricontact::runs {

/// What a command found: as data, and as a text for people, some of whose lines the data lack.
class Answer {
  public:
    /// `json` gives the data, an object (or a list, of an answer without notes); it is called for
    /// the one who asks for JSON alone.
    explicit Answer(std::function<std::string()> json, std::string text = {})
        : json_(std::move(json)), text_(std::move(text)) {}

    /// More of the text, with its line ends.
    Answer& add(const std::string& text);
    /// Lines of the text that the data lack: warnings, what is left out. In the data, where they
    /// stand apart, each begins with `of`.
    Answer& note(const std::string& lines, const std::string& of = {});

    /// The text, or as JSON the data; an object gets the notes, if there are any, as a list
    /// "notes".
    std::string printed(bool as_json) const;

  private:
    std::function<std::string()> json_;
    std::string text_;
    std::vector<std::string> notes_;
};

}  // namespace tricontact::runs
