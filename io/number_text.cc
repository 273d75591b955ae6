#include "io/number_text.h"

#include <algorithm>
#include <charconv>

namespace tricontact::io {

std::vector<std::string_view> words_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(blanks, end);
    }
    return words;
}

std::string_view without_plus(std::string_view word) {
    const bool more = word.size() > 1 && word[0] == '+' && word[1] != '-';
    return more ? word.substr(1) : word;
}

std::optional<double> number_in(std::string_view word) {
    word = without_plus(word);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size()) return {};
    return value;
}

}  // namespace tricontact::io
