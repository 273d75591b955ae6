#include "io/refusal.h"

#include <array>
#include <charconv>

#include "io/messages.h"

namespace tricontact::io {

std::string rounded(double value) {
    std::array<char, 32> buffer{};
    char* const begin = buffer.data();
    return {begin,
            std::to_chars(begin, begin + buffer.size(), value, std::chars_format::general, 4).ptr};
}

void refuse(const Document& document, const std::string& path, const std::string& rule,
            const std::string& remedy) {
    const Entry* entry = document.find(path);
    fail(document.place_of(path), entry ? entry->subject() : path + " (default)", rule, remedy);
}

std::string used(const Document& document, const std::string& first, const std::string& second) {
    return document.find(second) ? second : first;
}

}  // namespace tricontact::io
