// Height maps in the ASCII surface data file of ISO 25178-71: a header "key = value", the heights,
// a trailer, each ended by a line with a star.
#include "io/tables/height_map_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "io/tables/divided_text.h"

namespace tricontact::io {

namespace {

constexpr std::size_t most_mb = 512;  // 4096 x 4096 numbers as text

std::string extension(const std::string& path) {
    std::string end = std::filesystem::path(path).extension().string();
    std::ranges::transform(end, end.begin(), [](unsigned char c) { return std::tolower(c); });
    return end;
}

std::string line_place(const std::string& name, std::size_t line) {
    return name + ":" + std::to_string(line);
}

struct Reading {
    std::string_view text;
    const std::string& name;
    std::size_t at = 0, line = 0;
    DecimalReader numbers{name};

    std::string place() const { return line_place(name, line); }
    bool ended() const { return at >= text.size(); }
    std::string_view next_line() {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view found = text.substr(at, end - at);
        at = end + 1;
        ++line;
        return trimmed(found);
    }
};

struct Entry {
    std::string value, place;
};
using Header = std::map<std::string, Entry, std::less<>>;

Header read_header(Reading& file) {
    const std::string_view magic = file.next_line();
    if (magic != "aISO-1.0" && magic != "aISO-2.0" && magic != "aBCR-1.0")
        fail(file.place(), toml_string(shortened(magic, 20)),
             "is none of aISO-1.0, aISO-2.0 and aBCR-1.0, with which an ASCII surface data file "
             "begins",
             "export the surface as ASCII .sdf (ISO 25178-71)");
    Header header;
    while (!file.ended()) {
        const std::string_view line = file.next_line();
        if (line == "*") return header;
        const auto equals = line.find('=');
        if (equals == line.npos)
            fail(file.place(), toml_string(shortened(line, 40)), "is no \"key = value\"",
                 "the header ends with a line *");
        const std::string key(trimmed(line.substr(0, equals)));
        header[key] = {std::string(trimmed(line.substr(equals + 1))), file.place()};
    }
    fail(file.name, "", "the header does not end", "close it with a line *");
}

double value_of(const Header& header, const std::string& key, const std::string& name) {
    const auto entry = header.find(key);
    if (entry == header.end())
        fail(name, "", "the header lacks " + key, "export the surface again");
    const auto value = DecimalReader(name).number(entry->second.value, 0);
    if (!value || !(*value > 0) || !std::isfinite(*value))
        fail(entry->second.place, key + " = " + entry->second.value, "must be a positive number",
             "export the surface again");
    return *value;
}

int count_of(const Header& header, const std::string& key, const std::string& name) {
    const double value = value_of(header, key, name);
    if (value < 2 || value > most_height_nodes || value != std::floor(value))
        fail(header.find(key)->second.place, key + " = " + header.find(key)->second.value,
             "must be a whole number from 2 on", "export the surface again");
    return static_cast<int>(value);
}

void check_whole(const Header& header) {
    const auto compression = header.find("Compression");
    if (compression != header.end() && compression->second.value != "0")
        fail(compression->second.place, "Compression = " + compression->second.value,
             "compressed heights are not read", "export without compression");
}

/// Heights row by row, however they are broken into lines; BAD is the standard's missing value.
void read_heights(Reading& file, double unit, contact::HeightMap& map) {
    const std::size_t n = static_cast<std::size_t>(map.n_x) * map.n_y;
    map.height.reserve(n);
    while (!file.ended()) {
        const std::string_view line = file.next_line();
        if (line == "*") break;
        for (const auto word : words_of(line, " \t\r;")) {
            const double height = height_in(word, file.numbers, file.name, file.line);
            map.height.push_back(scaled(height, unit, file.place()));
            if (map.height.size() > n)
                fail(file.place(), "",
                     "more heights than NumPoints x NumProfiles = " + std::to_string(n),
                     "export the surface again");
        }
    }
    if (map.height.size() < n)
        fail(file.place(), "",
             "ends after " + std::to_string(map.height.size()) + " of " + std::to_string(n) +
                 " heights",
             "export the surface again");
}

}  // namespace

bool says_its_scale(const std::string& path) {
    return extension(path) == ".sdf";
}

contact::HeightMap read_height_map(const std::string& path,
                                   const std::optional<HeightMapScale>& scale) {
    const std::string end = extension(path);
    const bool known = std::ranges::count(std::array{".npy", ".sdf", ".csv", ".txt"}, end) > 0;
    if (!known)
        fail(path, "", "is no height map by its name",
             "name one that ends in .npy, .sdf, .csv or .txt");
    std::string bytes = read_input_file(path, "height map", most_mb);
    const std::string name = std::filesystem::path(path).filename().string();
    if (end == ".npy") return parse_npy(bytes, name, *scale);
    const std::string text = utf8_text(std::move(bytes), name);
    return end == ".sdf" ? parse_sdf(text, name) : parse_height_matrix(text, name, *scale);
}

contact::HeightMap parse_sdf(std::string_view text, const std::string& name) {
    Reading file{text, name};
    const Header header = read_header(file);
    check_whole(header);
    contact::HeightMap map{count_of(header, "NumPoints", name),
                           count_of(header, "NumProfiles", name),
                           {value_of(header, "Xscale", name), value_of(header, "Yscale", name)},
                           {},
                           "surface data file"};
    if (static_cast<double>(map.n_x) * map.n_y > most_height_nodes)
        fail(name, "", "more than 4096 x 4096 heights", "thin the surface out");
    read_heights(file, value_of(header, "Zscale", name), map);
    return map;
}

}  // namespace tricontact::io
