// Height maps as a matrix of numbers.

#include <cmath>
#include <optional>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "io/tables/height_map_file.h"

namespace tricontact::io {

namespace {

std::string place(const std::string& name, std::size_t line) {
    return name + ":" + std::to_string(line);
}

/// An empty cell between two commas is a missing value: the divider is one of these alone, blanks
/// are not counted.
char divider_in(std::string_view line) {
    for (const char c : {';', ',', '\t'})
        if (line.find(c) != line.npos) return c;
    return ' ';
}

double height_in(std::string_view word, const std::string& at) {
    const auto value = number_in(trimmed(word));
    if (!value || !std::isfinite(*value))
        fail(at, toml_string(shortened(word, 40)),
             "is no finite number: missing values are not filled in", "interpolate them first");
    return *value;
}

std::vector<double> row_in(std::string_view line, char divider, const std::string& at) {
    std::vector<double> row;
    if (divider == ' ') {
        for (const auto word : words_of(line)) row.push_back(height_in(word, at));
        return row;
    }
    for (std::size_t first = 0;;) {
        const std::size_t end = std::min(line.find(divider, first), line.size());
        row.push_back(height_in(line.substr(first, end - first), at));
        if (end == line.size()) return row;
        first = end + 1;
    }
}

}  // namespace

contact::HeightMap parse_height_matrix(std::string_view text, const std::string& name,
                                       const HeightMapScale& scale) {
    contact::HeightMap map{0, 0, {scale.spacing, scale.spacing}, {}};
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // mark of UTF-8
    std::optional<char> divider;                                  // as the first row has it
    std::size_t line = 0;
    for (std::size_t first = 0; first < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', first), text.size());
        const std::string_view content = trimmed(text.substr(first, end - first));
        first = end + 1;
        if (content.empty() || content.front() == '#') continue;
        if (!divider) divider = divider_in(content);
        const std::vector<double> row = row_in(content, *divider, place(name, line + 1));
        if (map.n_y > 0 && row.size() != static_cast<std::size_t>(map.n_x))
            fail(place(name, line + 1), "",
                 "has " + std::to_string(row.size()) + " heights, but the rows above have " +
                     std::to_string(map.n_x),
                 "make all rows alike");
        map.n_x = static_cast<int>(row.size());
        ++map.n_y;
        if (static_cast<double>(map.n_x) * map.n_y > most_height_nodes)
            fail(place(name, line + 1), "", "more than 4096 x 4096 heights",
                 "thin the surface out, or save a part of it");
        for (const double height : row)
            map.height.push_back(scaled(height, scale.unit, place(name, line + 1)));
    }
    if (map.n_x < 2 || map.n_y < 2)
        fail(name, "",
             "holds " + std::to_string(map.n_y) + " x " + std::to_string(map.n_x) + " heights",
             "give 2 x 2 at least");
    return map;
}

}  // namespace tricontact::io
