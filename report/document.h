#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tricontact::report {

/// Values over the first axis of a figure. NaN is a gap.
struct Curve {
    enum class Kind { line, points, line_and_points };

    std::string name;  ///< in the legend, plain text; curves of one name share an entry
    std::vector<double> x = {}, y = {};
    std::vector<double> x_error = {}, y_error = {};  ///< half widths of intervals; empty: none
    Kind kind = Kind::line;
    bool theory = false;             ///< a closed form: dashed, in grey unless it has a colour
    std::optional<int> colour = {};  ///< equal numbers, equal colours; empty: the next one

    void add(double at, double value) {
        x.push_back(at);
        y.push_back(value);
    }
};

/// The area between two curves: an interval of confidence.
struct Band {
    std::string name;  ///< in the legend; that of a curve: shares its entry and colour
    std::vector<double> x = {}, low = {}, high = {};
    std::optional<int> colour = {};  ///< empty: that of the curve of its name, else grey
};

/// Values over a grid, drawn as lines of equal value on a coloured ground.
struct ContourMap {
    std::string label;                ///< of the values, with unit
    std::vector<double> x, y;         ///< increasing
    std::vector<double> values;       ///< x fastest; NaN is a gap
    std::vector<double> levels = {};  ///< of the lines; empty: chosen
};

struct FigureAxis {
    std::string label = {};  ///< quantity and unit, "layer thickness b [mm]"
    bool logarithmic = false;
};

/// A figure as data: whoever draws it decides nothing about what it says.
struct Figure {
    std::string id;       ///< of its files: letters, digits, underscores
    std::string title;    ///< plain text
    std::string caption;  ///< what is drawn, for which setting, and how to read it
    FigureAxis x = {}, y = {};
    std::vector<Curve> curves = {};
    std::vector<Band> bands = {};
    std::optional<ContourMap> map = {};  ///< curves lie over it
};

/// A number with the half width of its interval.
struct WithError {
    double value = 0, error = 0;
};
/// A file, its path from the report's folder.
struct Link {
    std::string text, path;
};
/// Words, a number (NaN: undefined), a number with its error, or a file.
using Cell = std::variant<std::string, double, WithError, Link>;

/// A table that readers can sort by any column.
struct DocumentTable {
    struct Column {
        std::string heading;  ///< with unit
        int digits = 4;       ///< significant, of numbers; none where all are whole
    };
    std::string id;  ///< of its file: letters, digits, underscores
    std::string title;
    std::string note = {};  ///< definitions of columns, sources
    std::vector<Column> columns = {};
    std::vector<std::vector<Cell>> rows = {};
};

/// A statement that comes first in a report.
struct Verdict {
    enum class Standing { holds, fails, cannot_tell, finding };

    Standing standing = Standing::finding;
    std::string sentence;  ///< with its number
};

struct DocumentSection {
    std::string id;  ///< letters, digits, underscores
    std::string heading;
    std::vector<std::string> paragraphs = {};
    std::vector<Figure> figures = {};
    std::vector<DocumentTable> tables = {};
};

/// What a study, an identification, an evaluated experiment or a rig's check tells its reader.
struct Document {
    std::string kind;  ///< small line above the title: "Half-space deviation"
    std::string title;
    std::string lead = {};  ///< one paragraph: what was asked
    std::vector<Verdict> verdicts = {};
    std::vector<std::pair<std::string, std::string>> settings = {};  ///< name, value with unit
    std::vector<DocumentSection> sections = {};
    std::vector<std::pair<std::string, std::string>> files = {};  ///< text, path from the report
    std::string command = {};                                     ///< that makes it again
    std::string version = {};                                     ///< of the program
};

/// One HTML file that needs no network: verdicts, figures whose drawing (SVG) and data (CSV) can
/// be downloaded, tables that sort; light and dark, for screen, phone and paper. Texts are plain;
/// symbols of formulas in them ("f_T") are typeset. Same document, same bytes. Throws
/// std::invalid_argument for ids that are no words or occur twice and for columns that differ in
/// length.
std::string document_html(const Document& document);

}  // namespace tricontact::report
