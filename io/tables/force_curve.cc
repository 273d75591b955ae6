#include "io/tables/force_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "contact/base/special_values.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "io/keys/units.h"

namespace tricontact::io {

namespace {

constexpr std::string_view tip = "verticalTipPosition", deflection = "vDeflection";
/// Measured ones first: a piezo does not go where it is sent.
constexpr std::array<std::string_view, 5> heights{"measuredHeight", "smoothedMeasuredHeight",
                                                  "capacitiveSensorHeight",
                                                  "smoothedCapacitiveSensorHeight", "height"};
constexpr std::string_view segment_names = "extend, retract, pause";

struct Segment {
    std::string name;
    std::vector<std::string> columns, units;
    std::size_t header_line = 0;  // of the columns
    std::vector<TextLine> rows;
};

struct Curve {
    std::vector<Segment> segments;
    std::string spring_constant;
    std::size_t spring_line = 0;
};

std::vector<std::string> texts(std::string_view line) {
    std::vector<std::string> all;
    for (const auto word : words_of(line)) all.emplace_back(word);
    return all;
}

/// Key and value of "# key: value".
std::optional<std::pair<std::string_view, std::string_view>> entry_of(std::string_view line) {
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    const auto colon = line.find(':');
    if (colon == line.npos) return {};
    return std::pair{trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1))};
}

template <class Call>
void for_each_line(std::string_view text, const Call& call) {
    for (std::size_t number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find('\n'), text.size());
        call(TextLine{number, trimmed(text.substr(0, end))});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

/// What a segment does not say is that of the one before.
Curve read_curve(std::string_view text, const std::string& name) {
    Curve curve;
    Segment next;
    for_each_line(text, [&](const TextLine& line) {
        if (line.text.empty()) return;
        if (!line.text.starts_with('#')) {
            if (next.header_line == 0)
                fail(name + ':' + std::to_string(line.number), "",
                     "no line \"# columns:\" stands above this row",
                     "export the curve with its lines # columns and # units");
            next.rows.push_back(line);
            return;
        }
        if (!next.rows.empty()) {
            curve.segments.push_back(next);
            next.rows.clear();
            next.name.clear();
        }
        const auto entry = entry_of(line.text);
        if (!entry) return;
        const auto& [key, value] = *entry;
        if (key == "segment") next.name = value;
        if (key == "units") next.units = texts(value);
        if (key == "columns") {
            next.columns = texts(value);
            next.header_line = line.number;
        }
        if (key == "springConstant") {
            curve.spring_constant = value;
            curve.spring_line = line.number;
        }
    });
    if (!next.rows.empty()) curve.segments.push_back(next);
    return curve;
}

/// The only one of its name; null without one.
const Segment* segment_called(std::string_view word, const Curve& curve, const std::string& name) {
    const Segment* found = nullptr;
    for (const Segment& segment : curve.segments) {
        if (segment.name != word) continue;
        if (found)
            fail(name + ':' + std::to_string(segment.header_line), "",
                 "a second segment \"" + std::string(word) + "\" begins here",
                 "keep the one that is to be evaluated: curves are evaluated one by one");
        found = &segment;
    }
    return found;
}

/// The one that goes towards the sample.
const Segment& approach_of(const Curve& curve, const std::string& name) {
    if (curve.segments.empty()) fail(name, "", "the force curve has no rows", "export it again");
    if (curve.segments.size() == 1 && curve.segments[0].name.empty()) return curve.segments[0];
    std::vector<std::string> names;
    for (const Segment& segment : curve.segments)
        names.push_back(segment.name.empty() ? "without a name" : segment.name);
    const Segment* found = segment_called("extend", curve, name);
    if (!found)
        fail(name, "",
             "the force curve has no segment \"extend\", which goes towards the sample; it has " +
                 joined(names),
             "name it in its line \"# segment:\", which may be " + std::string(segment_names));
    return *found;
}

/// Columns of a segment, by their names.
class Columns {
  public:
    Columns(const Segment& segment, std::string name) : segment_(segment), name_(std::move(name)) {
        if (segment.units.size() != segment.columns.size())
            refuse("names " + std::to_string(segment.columns.size()) + " columns, but " +
                       std::to_string(segment.units.size()) + " units",
                   "export the curve with its lines # columns and # units");
    }

    bool has(std::string_view column) const {
        return std::ranges::count(segment_.columns, column) > 0;
    }

    [[noreturn]] void refuse(const std::string& rule, const std::string& remedy) const {
        fail(place(segment_.header_line), "", "the segment " + rule, remedy);
    }

    /// In SI units.
    std::vector<double> values(std::string_view column, Dimension dimension,
                               const std::string& remedy) const {
        const auto at = static_cast<std::size_t>(std::ranges::find(segment_.columns, column) -
                                                 segment_.columns.begin());
        double factor = 1;
        try {
            factor = parse_quantity("1 " + segment_.units.at(at), dimension);
        } catch (const QuantityError& error) {
            refuse("has " + std::string(column) + " in " +
                       toml_string(shortened(segment_.units.at(at), 20)) + ": " + error.rule,
                   remedy);
        }
        std::vector<double> all;
        for (const TextLine& row : segment_.rows) all.push_back(factor * number(row, at));
        return all;
    }

  private:
    std::string place(std::size_t line) const { return name_ + ':' + std::to_string(line); }

    double number(const TextLine& row, std::size_t at) const {
        const auto words = words_of(row.text);
        if (words.size() != segment_.columns.size())
            fail(place(row.number), "",
                 "has " + std::to_string(words.size()) + " columns instead of " +
                     std::to_string(segment_.columns.size()),
                 "correct or remove the row");
        const double value = number_in(words[at]).value_or(contact::undefined);
        if (!std::isfinite(value))
            fail(place(row.number), segment_.columns[at] + " = " + shortened(words[at], 40),
                 "must be a finite number", "correct or remove the row");
        return value;
    }

    const Segment& segment_;
    std::string name_;
};

/// [N/m]
double spring_constant(const Curve& curve, const std::string& name) {
    const auto words = words_of(curve.spring_constant);
    const double value = words.empty() ? 0 : number_in(words[0]).value_or(0);
    const bool in_si = words.size() == 1 || (words.size() == 2 && words[1] == "N/m");
    if (!(value > 0) || !std::isfinite(value) || !in_si)
        fail(name + ':' + std::to_string(curve.spring_line),
             "springConstant = " + shortened(curve.spring_constant, 40),
             "must be a positive number of N/m", "correct it, or export verticalTipPosition");
    return value;
}

/// Depths, from anywhere, and forces of a segment; `reading`: how the depth was got.
ForceCurve rows_of(const Segment& segment, const Curve& curve, const std::string& name,
                   std::size_t most_rows) {
    const Columns columns(segment, name);
    if (segment.rows.size() > most_rows)
        columns.refuse("has more than " + std::to_string(most_rows) + " rows",
                       "thin it out, or take means");
    if (!columns.has(deflection))
        columns.refuse("has no column vDeflection", "export the force as vDeflection in N");
    const std::string calibrate =
        "export it in N, with the sensitivity and the spring constant of the cantilever";
    ForceCurve found;
    found.force = columns.values(deflection, Dimension::force, calibrate);
    const auto height = std::ranges::find_if(heights, [&](auto one) { return columns.has(one); });
    found.reading = "-verticalTipPosition";
    if (columns.has(tip)) {
        found.depth = columns.values(tip, Dimension::length, "export it in m");
    } else if (height == heights.end()) {
        columns.refuse("has no column verticalTipPosition", "export it, or measuredHeight");
    } else {
        if (curve.spring_constant.empty())
            columns.refuse("has " + std::string(*height) +
                               ", which the bending of the cantilever is part of, and the file no "
                               "line # springConstant",
                           "export verticalTipPosition, or add # springConstant: 0.05");
        found.depth = columns.values(*height, Dimension::length, "export it in m");
        const double k = spring_constant(curve, name);
        for (std::size_t i = 0; i < found.depth.size(); ++i) found.depth[i] += found.force[i] / k;
        found.reading =
            "-(" + std::string(*height) + " + vDeflection/k), k = " + shortest(k) + " N/m";
    }
    for (double& value : found.depth) value = 0 - value;
    return found;
}

}  // namespace

bool is_force_curve(std::string_view text) {
    bool has_columns = false, has_units = false;
    for_each_line(text, [&](const TextLine& line) {
        const auto entry = entry_of(line.text);
        has_columns = has_columns || (entry && entry->first == "columns");
        has_units = has_units || (entry && (entry->first == "units" || entry->first == "segment"));
    });
    return has_columns && has_units;
}

ForceCurve force_curve(std::string_view text, const std::string& name, std::size_t most_rows,
                       bool with_retraction) {
    const Curve curve = read_curve(text, name);
    const Segment& approach = approach_of(curve, name);
    ForceCurve found = rows_of(approach, curve, name, most_rows);
    // Where the force is largest the tip is deepest.
    const auto most = std::ranges::max_element(found.force) - found.force.begin();
    const double mean = std::accumulate(found.depth.begin(), found.depth.end(), 0.) /
                        static_cast<double>(found.depth.size());
    if (found.depth[static_cast<std::size_t>(most)] < mean)
        Columns(approach, name)
            .refuse(
                "has its largest force far from the sample: heights that fall towards it "
                "are expected, and forces that are positive where it repels",
                "turn the sign of one of the columns");
    std::string segments = "segment " + (approach.name.empty() ? "without a name" : approach.name);
    if (const Segment* pulled =
            with_retraction ? segment_called("retract", curve, name) : nullptr) {
        const ForceCurve more = rows_of(*pulled, curve, name, most_rows);
        found.depth.insert(found.depth.end(), more.depth.begin(), more.depth.end());
        found.force.insert(found.force.end(), more.force.begin(), more.force.end());
        segments = "segments " + approach.name + " and " + pulled->name;
    }
    found.reading =
        segments + " of " + std::to_string(curve.segments.size()) + ", depth = " + found.reading;
    return found;
}

}  // namespace tricontact::io
