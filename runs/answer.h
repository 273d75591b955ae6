#pragma once

#include <string>

namespace tricontact::runs {

/// What a command found: the same as data and as text for people.
struct Answer {
    std::string json;        ///< the data, an object or a list of JSON
    std::string text;        ///< what a terminal shows, with its line ends
    std::string notes = {};  ///< lines of that text which the data lack: warnings, what is left out
};

/// The text, or as JSON the data; an object gets the notes, if there are any, as a list "notes".
std::string printed(const Answer& answer, bool as_json);

}  // namespace tricontact::runs
