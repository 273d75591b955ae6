#include "report/table_style.h"

#include <cmath>

#include "report/format.h"

namespace tricontact::report {

DocumentTable::Column column(const std::string& text) {
    const auto colon = text.rfind(':');
    if (colon == std::string::npos) return {text};
    return {text.substr(0, colon), std::stoi(text.substr(colon + 1))};
}

bool is_text(const Cell& content) {
    return std::holds_alternative<std::string>(content) || std::holds_alternative<Link>(content);
}

ColumnStyle style_of(const DocumentTable& content, std::size_t column) {
    constexpr double most = 1e6;  // beyond, numbers are magnitudes and no counts
    ColumnStyle style{.first = column == 0,
                      .digits = content.columns[column].digits,
                      .change = content.columns[column].change};
    for (const std::vector<Cell>& row : content.rows) {
        style.words = style.words && is_text(row[column]);
        if (const auto* number = std::get_if<double>(&row[column]))
            style.whole = style.whole && (std::isnan(*number) || (std::abs(*number) < most &&
                                                                  std::rint(*number) == *number));
    }
    return style;
}

std::string number_text(const Cell& cell, const ColumnStyle& style) {
    if (const auto* count = std::get_if<int>(&cell)) return std::to_string(*count);
    if (const auto* measured = std::get_if<WithError>(&cell))
        return with_error(measured->value, measured->error, style.digits);
    const double number = std::get<double>(cell);
    if (style.change) {  // "+16.5": the heading has the unit
        const std::string text = percent(1 + number / 100);
        return text.substr(0, text.find(' '));
    }
    return style.whole ? as_given(number) : significant(number, style.digits);
}

std::string cell_text(const Cell& cell, const ColumnStyle& style) {
    if (const auto* words = std::get_if<std::string>(&cell)) return *words;
    if (const auto* link = std::get_if<Link>(&cell)) return link->text;
    return number_text(cell, style);
}

}  // namespace tricontact::report
