#pragma once

#include <cstddef>
#include <optional>
#include <string>

// Numbers in sentences, the same in every folder.

namespace tricontact::contact {

/// `digits` significant digits with trailing zeros kept, a true minus sign, powers of ten beyond
/// 1e5 and below 1e-3 ("1.20·10⁻⁷"); an en dash where undefined.
std::string significant(std::optional<double> value, int digits = 4);

/// Value and half width of its interval as the Particle Data Group rounds them: the error to two
/// digits where its leading three lie in 100 ... 354, else to one, the value to the same decimal
/// ("0.83 ± 0.12", "(1.234 ± 0.005)·10⁻⁷"). Beside an error below 1e-7 of it, or an undefined
/// one, the value has `digits` significant digits.
std::string with_error(double value, double error, int digits = 4);

/// A decimal prefix of SI.
struct UnitPrefix {
    double factor = 1;
    const char* symbol = "";
};
/// The one that keeps a magnitude between 1 and 1000.
UnitPrefix fitting_prefix(double magnitude);

/// Number and unit: "4.52 mm".
std::string quantity(double value, const std::string& base, int digits = 4);

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
