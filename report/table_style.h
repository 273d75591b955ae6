#pragma once

#include <cstddef>
#include <string>

#include "report/document.h"

// How cells of tables are written, whoever lays them out.
namespace tricontact::report {

/// How the cells of a column are written.
struct ColumnStyle {
    bool first = false;  ///< words in it are headings of their rows
    bool words = true;   ///< nothing else: aligned left
    bool whole = true;   ///< numbers, if any, are whole: written without decimals
    int digits = 4;      ///< significant, of other numbers
    bool change = false;
};

ColumnStyle style_of(const DocumentTable& table, std::size_t column);

bool is_text(const Cell& cell);
/// A number, a count or a number with its error as people read it.
std::string number_text(const Cell& cell, const ColumnStyle& style);
/// The same, or the words.
std::string cell_text(const Cell& cell, const ColumnStyle& style);

}  // namespace tricontact::report
