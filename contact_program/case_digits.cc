#include "contact_program/case_digits.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

/// A digit, what CONTACT takes, what is a case here, why nothing else is, and its place.
struct Digit {
    char letter;
    std::string_view allowed, known, rule, remedy;
    int CaseDigits::*place = nullptr;
};

const std::vector<Digit> words[3] = {
    {{'P', "0123", "02", "a case goes on from the one before or begins again", "give 0 or 2",
      &CaseDigits::previous},
     {'B', "0123456", "0",
      "only the full normal problem is solved, no thin sheet and no prescribed pressure", "give 0",
      &CaseDigits::bound},
     {'T', "0123", "0123", "", "", &CaseDigits::tangential},
     {'N', "01", "01", "", "", &CaseDigits::normal},
     {'F', "012", "012", "", "", &CaseDigits::force},
     {'S', "0123", "0123", "", "", &CaseDigits::stress}},
    {{'V', "023", "0", "friction is the same everywhere", "give 0", &CaseDigits::variable},
     {'L', "012346", "012346", "", "", &CaseDigits::friction},
     {'D', "012", "012", "", "", &CaseDigits::cells},
     {'C', "012349", "0129",
      "only half-spaces with constant tractions per cell and coefficients of a file are read",
      "give 2 or 9", &CaseDigits::influence},
     {'M', "01234567", "014", "no model here has the springs of simplified theory (FASTSIM)",
      "give 0", &CaseDigits::material},
     {'Z', "012", "012", "", "", &CaseDigits::distance},
     {'E', "01239", "019", "spin slides along both axes", "give 0, 1 or 9", &CaseDigits::extra}},
    {{'X', "01", "01", "", "", &CaseDigits::debug},
     {'H', "013", "013", "", "", &CaseDigits::heat},
     {'G', "012345", "012345", "", "", &CaseDigits::solver},
     {'I', "0123", "0123", "", ""},
     {'A', "012", "012", "", ""},
     {'O', "0123456", "0123456", "", ""},
     {'W', "0123456789", "0123456789", "", ""},
     {'R', "0123", "01", "every case is computed", "give 0 or 1", &CaseDigits::after}}};

bool contains(std::string_view digits, int value) {
    return digits.find(static_cast<char>('0' + value)) != std::string_view::npos;
}

/// "from 0 to 3", or the digits one by one.
std::string choice_of(std::string_view allowed) {
    const bool row = allowed.back() - allowed.front() == static_cast<int>(allowed.size()) - 1;
    if (row) return fmt::format("must be from {} to {}", allowed.front(), allowed.back());
    return fmt::format("must be one of {}", fmt::join(allowed, ", "));
}

}  // namespace

CaseDigits read_case_digits(InputLines& lines) {
    CaseDigits digits;
    for (std::size_t word = 0; word < std::size(words); ++word) {
        std::string letters;
        for (const Digit& digit : words[word]) letters += digit.letter;
        const std::vector<int> values = lines.digits(letters.size(), letters);
        digits.lines[word] = lines.line();
        for (std::size_t k = 0; k < values.size(); ++k) {
            const Digit& digit = words[word][k];
            if (!contains(digit.allowed, values[k]))
                lines.refuse(fmt::format("{} = {}", digit.letter, values[k]),
                             choice_of(digit.allowed), "correct it");
            if (digit.place) digits.*digit.place = values[k];
        }
    }
    digits.line = digits.lines[0];
    return digits;
}

void check_known_digits(const CaseDigits& digits, const std::string& name) {
    for (std::size_t word = 0; word < std::size(words); ++word)
        for (const Digit& digit : words[word])
            if (digit.place && !contains(digit.known, digits.*digit.place))
                refuse_at(name, digits.lines[word],
                          fmt::format("{} = {}", digit.letter, digits.*digit.place), digit.rule,
                          digit.remedy);
}

}  // namespace tricontact::contact_program
