#include "meshes/messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/error.h"

namespace tricontact::meshes {

namespace {

std::string one_line(std::string_view text) {
    std::string out(text);
    std::replace_if(
        out.begin(), out.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return out;
}

}  // namespace

void fail(std::string_view name, std::string_view what, std::string_view remedy) {
    throw contact::InputError(one_line(fmt::format("{}: {}; {}", name, what, remedy)));
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40;
    return '"' + one_line(text.substr(0, longest)) + (text.size() > longest ? "...\"" : "\"");
}

std::string place(const Point& point) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", point[0], point[1], point[2]);
}

}  // namespace tricontact::meshes
