#include "io/keys/key.h"

namespace tricontact::io {

bool Range::contains(double value) const {
    return (low_included ? value >= low : value > low) &&
           (high_included ? value <= high : value < high);
}

std::string_view Key::section() const {
    return section_of(path);
}

std::string_view Key::name() const {
    return name_of_key(path);
}

std::string_view section_of(std::string_view path) {
    const auto dot = path.substr(0, path.find('"')).rfind('.');
    return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

std::string_view name_of_key(std::string_view path) {
    const std::string_view section = section_of(path);
    return section.empty() ? path : path.substr(section.size() + 1);
}

}  // namespace tricontact::io
