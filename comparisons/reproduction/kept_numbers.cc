#include "comparisons/reproduction/kept_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <unordered_map>

#include "comparisons/quantities/quantity.h"
#include "io/keys/json_text.h"
#include "io/keys/messages.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

/// What differs from run to run: times that it took, and what is over one.
bool is_time(const std::string& name) {
    if (name.ends_with("_per_s")) return true;
    return std::ranges::any_of(all_quantities(), [&](const Quantity* q) {
        return !q->is_column && std::string(q->unit) == "s" && (name == q->key || name == q->name);
    });
}

std::optional<double> number_in(const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number)) return {};
    return number;
}

/// What stands in brackets at the end of a heading, or behind the last underscore of a key.
std::string unit_in(const std::string& quantity) {
    const auto bracket = quantity.rfind('[');
    if (bracket != std::string::npos) return quantity.substr(bracket);
    const auto begin = std::min(quantity.rfind('/') + 1, quantity.size());
    const auto underscore = quantity.rfind('_');
    return underscore == std::string::npos || underscore < begin ? ""
                                                                 : quantity.substr(underscore + 1);
}

void set_scales(std::vector<KeptNumber>& numbers) {
    std::map<std::string, double> of_unit;
    for (const KeptNumber& number : numbers)
        if (number.value) {
            double& largest = of_unit[unit_in(number.quantity)];
            largest = std::max(largest, std::abs(*number.value));
        }
    for (KeptNumber& number : numbers) number.noise_scale = of_unit[unit_in(number.quantity)];
}

/// The values of a JSON document.
class JsonReader {
  public:
    std::vector<KeptNumber> read(const json& document) {
        add(document, "", "");
        const json none = json::object();
        const json& error = document.is_object() && document.contains("numerical_error")
                                ? document["numerical_error"]
                                : none;
        if (error.is_object() && error.contains("half_widths"))
            for (const auto& [key, width] : error["half_widths"].items())
                state("models/" + error.value("model", "") + '/' + key, width);
        return std::move(numbers_);
    }

  private:
    void add(const json& item, const std::string& quantity, const std::string& place) {
        if (item.is_object()) return add_members(item, quantity, place);
        if (item.is_array()) return add_elements(item, quantity, place);
        KeptNumber number{.quantity = quantity, .place = place, .text = item.dump()};
        if (item.is_number()) number.value = item.get<double>();
        number.scale = std::abs(number.value.value_or(0));
        at_.emplace(place, numbers_.size());
        numbers_.push_back(std::move(number));
    }
    void add_members(const json& item, const std::string& quantity, const std::string& place) {
        const std::string slash = quantity.empty() ? "" : "/";
        for (const auto& [key, value] : item.items()) {
            if (is_time(key) || (quantity.empty() && key == "version")) continue;
            if (quantity == "case/fem" && key == "cache") continue;  // changes no number
            add(value, quantity + slash + key, place + slash + key);
        }
        for (const auto& [of, error] :
             {std::pair("value", "error"), {"value", "standard_error"}, {"worst", "allowed"}})
            if (item.contains(of) && item.contains(error)) state(place + slash + of, item[error]);
        for (const auto& [key, value] : item.items())
            if (item.contains(key + "_error")) state(place + slash + key, item[key + "_error"]);
    }
    void add_elements(const json& item, const std::string& quantity, const std::string& place) {
        const std::size_t first = numbers_.size();
        for (std::size_t i = 0; i < item.size(); ++i)
            add(item[i], quantity, fmt::format("{}/{}", place, i));
        if (std::ranges::any_of(item, [](const json& one) { return one.is_structured(); })) return;
        double largest = 0;
        for (std::size_t i = first; i < numbers_.size(); ++i)
            largest = std::max(largest, numbers_[i].scale);
        for (std::size_t i = first; i < numbers_.size(); ++i) numbers_[i].scale = largest;
    }
    void state(const std::string& place, const json& error) {
        if (!error.is_number()) return;
        const auto [begin, end] = at_.equal_range(place);
        for (auto at = begin; at != end; ++at)
            numbers_[at->second].stated_error = error.get<double>();
    }

    std::vector<KeptNumber> numbers_;
    std::unordered_multimap<std::string, std::size_t> at_;  // by place
};

using Record = std::vector<std::string>;

/// The next record (RFC 4180) from `at` on, which moves behind it.
Record next_record(const std::string& text, std::size_t& at) {
    Record record(1);
    bool is_quoted = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"' && is_quoted && at + 1 < text.size() && text[at + 1] == '"')
            record.back() += text[++at];
        else if (c == '"')
            is_quoted = !is_quoted;
        else if (c == ',' && !is_quoted)
            record.emplace_back();
        else if (c == '\n' && !is_quoted)
            break;
        else
            record.back() += c;
    }
    ++at;
    return record;
}

/// A table: its heading, its lines, the largest value of each column.
void add_table(const std::vector<Record>& lines, std::size_t first_line,
               std::vector<KeptNumber>& numbers) {
    const Record& heading = lines.front();
    std::vector<double> largest(heading.size(), 0);
    for (std::size_t row = 1; row < lines.size(); ++row)
        for (std::size_t i = 0; i < std::min(heading.size(), lines[row].size()); ++i)
            largest[i] = std::max(largest[i], std::abs(number_in(lines[row][i]).value_or(0)));
    for (std::size_t row = 0; row < lines.size(); ++row) {
        if (is_time(lines[row].front())) continue;
        for (std::size_t i = 0; i < lines[row].size(); ++i) {
            const std::string& name = row > 0 && i < heading.size() ? heading[i] : "heading";
            if (row > 0 && is_time(name)) continue;
            const bool is_told = row > 0 && i + 1 < std::min(heading.size(), lines[row].size()) &&
                                 heading[i + 1] == "± " + heading[i];
            numbers.push_back(
                {.quantity = name,
                 .place = fmt::format("line {}, {}", first_line + row, name),
                 .text = lines[row][i],
                 .value = number_in(lines[row][i]),
                 .stated_error = is_told ? number_in(lines[row][i + 1]) : std::nullopt,
                 .scale = row > 0 && i < largest.size()
                              ? largest[i]
                              : std::abs(number_in(lines[row][i]).value_or(0))});
        }
    }
}

/// Tables with an empty line between them.
std::vector<KeptNumber> csv_numbers(const std::string& text) {
    std::vector<KeptNumber> numbers;
    std::vector<Record> lines;
    std::size_t line = 1, first_line = 1;
    const auto end_table = [&] {
        if (!lines.empty()) add_table(lines, first_line, numbers);
        lines.clear();
        first_line = line + 1;
    };
    for (std::size_t at = 0; at < text.size(); ++line) {
        Record record = next_record(text, at);
        if (record.size() == 1 && record.front().empty())
            end_table();
        else
            lines.push_back(std::move(record));
    }
    end_table();
    return numbers;
}

}  // namespace

std::vector<KeptNumber> numbers_in(const std::string& name, const std::string& text) {
    std::vector<KeptNumber> numbers;
    if (name.ends_with(".json")) {
        const json document = io::parsed_json(text);
        if (document.is_discarded())
            throw std::runtime_error(
                name + " is no JSON, or nests too deep, or has a number beyond double");
        numbers = JsonReader().read(document);
    } else if (name.ends_with(".csv")) {
        if (io::first_non_utf8(text) != std::string::npos)
            throw std::runtime_error(name + " is no text in UTF-8");
        numbers = csv_numbers(text);
    } else {
        throw std::runtime_error(name + " is neither JSON nor CSV");
    }
    set_scales(numbers);
    return numbers;
}

}  // namespace tricontact::comparisons
