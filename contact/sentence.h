#pragma once

#include <cstddef>
#include <string>

namespace tricontact::contact {

/// A sentence of a report beside the condition under which it is true. `text` is asked only where
/// `holds` says so.
template <class Subject>
struct Sentence {
    bool (*holds)(const Subject&);
    std::string (*text)(const Subject&);
};

template <class Subject>
bool always(const Subject&) {
    return true;
}

/// Those that are true, in their order, with spaces between them.
template <class Subject, std::size_t n>
std::string told(const Sentence<Subject> (&sentences)[n], const Subject& subject) {
    std::string text;
    for (const Sentence<Subject>& one : sentences) {
        if (!one.holds(subject)) continue;
        if (!text.empty()) text += ' ';
        text += one.text(subject);
    }
    return text;
}

}  // namespace tricontact::contact
