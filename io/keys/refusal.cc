#include "io/keys/refusal.h"

#include <array>
#include <charconv>
#include <filesystem>

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

void check_file_there(const Document& document, const std::string& path, const std::string& file,
                      const std::string& remedy) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        refuse(document, path, "there is no such file: " + file,
               remedy + "; a relative name is meant from the folder of the case file");
}

std::string used(const Document& document, const std::string& first, const std::string& second) {
    return document.find(second) ? second : first;
}

}  // namespace tricontact::io
