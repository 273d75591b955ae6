#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "report/format.h"
#include "report/gnuplot_figure.h"

namespace tricontact::report {

std::string gnuplot_label(const std::string& text) {
    // What a page would show, its tags and characters in gnuplot's notation.
    constexpr std::pair<std::string_view, std::string_view> notation[] = {
        {"<sub>", "_{"}, {"</sub>", "}"},  {"<sup>", "^{"},  {"</sup>", "}"},  {"<i>", ""},
        {"</i>", ""},    {"&amp;", "\\&"}, {"&apos;", "''"}, {"&quot;", "\""}, {"&lt;", "<"},
        {"&gt;", ">"},   {"_", "\\_"},     {"^", "\\^"},     {"@", "\\@"},     {"{", "\\{"},
        {"}", "\\}"},    {"~", "\\~"},     {"\\", "\\\\"}};
    const std::string html = typeset(text);
    std::string result;
    for (std::size_t at = 0; at < html.size();) {
        const auto* found = std::ranges::find_if(notation, [&](const auto& pair) {
            return html.compare(at, pair.first.size(), pair.first) == 0;
        });
        if (found == std::end(notation)) {
            result += html[at++];
        } else {
            result += found->second;
            at += found->first.size();
        }
    }
    return result;
}

}  // namespace tricontact::report
