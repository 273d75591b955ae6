#include "meshes/messages.h"

#include <fmt/format.h>

#include "contact/base/error.h"
#include "contact/base/plain_text.h"

namespace tricontact::meshes {

void fail(std::string_view name, std::string_view what, std::string_view remedy) {
    throw contact::InputError(contact::plain_text(fmt::format("{}: {}; {}", name, what, remedy)));
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40;
    return '"' + contact::plain_text(text.substr(0, longest)) +
           (text.size() > longest ? "...\"" : "\"");
}

std::string place(const Point& point) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", point[0], point[1], point[2]);
}

}  // namespace tricontact::meshes
