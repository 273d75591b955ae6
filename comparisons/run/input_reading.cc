#include "comparisons/run/input_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/case/case_input.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::HeightMap;

std::string metres_text(double value) {
    return report::quantity(value, "m", 4);
}

std::string sides_text(double x, double y) {
    return x == y ? metres_text(x) : metres_text(x) + " x " + metres_text(y);
}

/// The nodes of an extreme height.
struct Extreme {
    int n = 0;
    contact::Vector2 first{};  ///< position of the first one from the middle node [m]
    bool on_border = false;    ///< one of them
};

Extreme extreme_of(const HeightMap& map, double height) {
    Extreme found;
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i) {
            if (map.at(i, j) != height) continue;
            if (found.n++ == 0)
                found.first = {(i - map.n_x / 2) * map.spacing[0],
                               (j - map.n_y / 2) * map.spacing[1]};
            found.on_border =
                found.on_border || i == 0 || j == 0 || i + 1 == map.n_x || j + 1 == map.n_y;
        }
    return found;
}

std::string place_text(const Extreme& extreme) {
    return fmt::format("x = {}, y = {} from the middle node", metres_text(extreme.first[0]),
                       metres_text(extreme.first[1]));
}

/// Terminals may have no other letters.
std::string in_plain_letters(std::string text) {
    for (const auto& [letter, plain] : {std::pair<std::string, std::string>{"−", "-"}, {"×", "x"}})
        for (auto at = text.find(letter); at != text.npos; at = text.find(letter))
            text.replace(at, letter.size(), plain);
    return text;
}

std::string border_sentence(double share) {
    return fmt::format("cells at the border of the height map carry {} of F_N",
                       report::share(share));
}

constexpr const char* border_remedy =
    "beyond the border there is no body: give a larger map, bem.period for a surface that goes on, "
    "or indenter.heights if the map is turned over";

}  // namespace

std::vector<std::string> map_sentences(const Case& c) {
    if (!c.indenter.height_map) return {};
    const HeightMap& map = *c.indenter.height_map;
    const auto [low, high] = std::ranges::minmax(map.height);
    std::vector<std::string> out{fmt::format(
        "Height map, read as {}: {} x {} nodes (x by y), {} apart, {} x {}; heights differ by {}.",
        map.layout.empty() ? "heights" : map.layout, map.n_x, map.n_y,
        sides_text(map.spacing[0], map.spacing[1]), metres_text((map.n_x - 1) * map.spacing[0]),
        metres_text((map.n_y - 1) * map.spacing[1]), metres_text(high - low))};
    const bool outward = c.indenter.heights == Case::Heights::outward;
    const Extreme first = extreme_of(map, low), last = extreme_of(map, high);
    const std::string nodes = first.n == 1 ? "node" : fmt::format("{} nodes", first.n);
    out.push_back(
        fmt::format("Heights point {}: the {} {} of the file press{} first, at {}.",
                    outward ? "out of the indenter (heights = \"outward\")"
                            : "away from the substrate (heights = \"gap\")",
                    outward ? "highest" : "lowest", nodes, first.n == 1 ? "es" : "",
                    first.n == 1 ? place_text(first) : place_text(first) + " and elsewhere"));
    if (!c.period && first.on_border && !last.on_border)
        out.push_back(fmt::format(
            "What presses first lies on the border of the map, and what lies farthest from the "
            "substrate does not: if the indenter bulges towards the substrate, the map is turned "
            "over; heights = \"{}\" turns it.",
            outward ? "gap" : "outward"));
    return out;
}

std::vector<std::string> input_sentences(const Case& c) {
    std::vector<std::string> out;
    for (const std::string& sentence : map_sentences(c)) out.push_back(in_plain_letters(sentence));
    const double shear = c.substrate.shear_modulus();
    const io::RelaxationFits& fits = io::relaxation_fits(c);
    if (fits.dma)
        for (const std::string& remark : contact::remarks(*fits.dma, shear))
            out.push_back(remark + '.');
    if (fits.test)
        for (const std::string& remark :
             contact::remarks(*fits.test, fits.test->table.is_young ? c.substrate.young : shear))
            out.push_back(remark + '.');
    return out;
}

std::vector<report::Verdict> border_verdicts(const Case& c, const std::vector<Results>& results) {
    std::vector<report::Verdict> verdicts;
    if (!c.indenter.height_map || c.period) return verdicts;
    for (const Results& s : results) {
        const auto share = s.number(quantities::border_force_share);
        if (!share) continue;
        const std::string name = report::display_name(s.model);
        if (*share > 0)
            verdicts.push_back({report::Verdict::Standing::violated,
                                fmt::format("The height map is larger than the contact: {} ({}); "
                                            "{}.",
                                            border_sentence(*share), name, border_remedy)});
        else
            verdicts.push_back({report::Verdict::Standing::holds,
                                fmt::format("The height map is larger than the contact: no cell at "
                                            "its border carries pressure ({}).",
                                            name)});
    }
    return verdicts;
}

std::string border_warning(const Results& results) {
    const auto share = results.number(quantities::border_force_share);
    if (!share || !(*share > 0)) return {};
    return fmt::format("{}: {}: {}", results.model, border_sentence(*share), border_remedy);
}

std::string border_warning(const std::vector<const Results*>& runs) {
    const auto share = [](const Results* one) {
        return one->number(quantities::border_force_share).value_or(0);
    };
    const auto n = std::ranges::count_if(runs, [&](const Results* one) { return share(one) > 0; });
    if (n == 0) return {};
    return fmt::format(
        "in {} of {} runs contact reaches the border of the height map; the worst: {}", n,
        runs.size(), border_warning(**std::ranges::max_element(runs, {}, share)));
}

}  // namespace tricontact::comparisons
