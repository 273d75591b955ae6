#include "report/table_text.h"

#include <algorithm>
#include <vector>

#include "report/table_style.h"

namespace tricontact::report {

namespace {

/// Characters, not bytes.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // not a continuation in UTF-8
    }));
}

}  // namespace

std::string table_text(const DocumentTable& table, std::size_t most_columns) {
    std::vector<std::string> lines(table.rows.size() + 1);
    for (std::size_t k = 0; k < std::min(most_columns, table.columns.size()); ++k) {
        const ColumnStyle style = style_of(table, k);
        std::vector<std::string> cells{table.columns[k].heading};
        for (const auto& row : table.rows) cells.push_back(cell_text(row[k], style));
        const std::size_t width = width_of(*std::ranges::max_element(cells, {}, width_of));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::string space(width - width_of(cells[i]), ' ');
            lines[i] += (k > 0 ? "  " : "") + (style.words ? cells[i] + space : space + cells[i]);
        }
    }
    std::string text;
    for (std::string& line : lines) text += line.erase(line.find_last_not_of(' ') + 1) + '\n';
    return text;
}

}  // namespace tricontact::report
