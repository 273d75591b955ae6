#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "report/figure.h"
#include "report/player.h"

namespace tricontact::report {

/// A number with the half width of its interval.
struct WithError {
    double value = 0, error = 0;
};
/// A file, its path from the report's folder.
struct Link {
    std::string text, path;
};
/// Words, a number (NaN: undefined), a count, a number with its error, or a file.
using Cell = std::variant<std::string, double, int, WithError, Link>;

/// Over a unit; empty: undefined.
inline Cell number_cell(std::optional<double> value, double unit = 1) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN()) / unit;
}

/// A table that readers can sort by any column.
struct DocumentTable {
    struct Column {
        std::string heading;  ///< with unit
        int digits = 4;       ///< significant, of numbers; none where all are whole
        bool change = false;  ///< numbers are differences in percent: with their sign
    };
    std::string id;  ///< of its file: letters, digits, hyphens, underscores
    std::string title;
    std::string note = {};  ///< definitions of columns, sources
    std::vector<Column> columns = {};
    std::vector<std::vector<Cell>> rows = {};
    bool folded = false;  ///< shown on a click
    bool stacks = false;  ///< on a phone each row is a paragraph, its cells lines
};

/// A column by its heading, with the significant digits of its numbers behind a colon where these
/// are not four: "w:3".
DocumentTable::Column column(const std::string& text);
/// The columns of a table.
template <class... Texts>
std::vector<DocumentTable::Column> columns(const Texts&... texts) {
    return {column(texts)...};
}

/// A statement that comes first in a report.
struct Verdict {
    /// Of an assumption it holds, is violated or not testable; a comparison with a tolerance
    /// passes, fails or is not resolved.
    enum class Standing { holds, violated, not_testable, finding, pass, fail, not_resolved };

    Standing standing = Standing::finding;
    std::string sentence;   ///< with its number
    std::string word = {};  ///< instead of the standing's
    /// As a row of a table, if it has a subject: the assumption or what is compared; the number
    /// that decides; its threshold; what follows for what is measured.
    std::string subject = {}, number = {}, threshold = {}, effect = {};
};

/// "holds", "violated", "not testable", "finding", "pass", "fail", "not resolved": the words of
/// pages, terminal and JSON.
const char* word_of(Verdict::Standing standing);

/// Failures first, then what could not be decided, then the rest, each in the given order.
std::vector<Verdict> by_severity(std::vector<Verdict> verdicts);

struct DocumentSection {
    std::string id;  ///< letters, digits, hyphens, underscores
    std::string heading;
    std::vector<std::string> paragraphs = {};
    std::vector<Figure> figures = {};
    std::vector<DocumentTable> tables = {};
    bool printed = false;  ///< on paper also where nobody has unfolded it
    bool open = false;     ///< unfolded from the beginning
};

/// What a study, an identification, an evaluated experiment or a rig's check tells its reader.
struct Document {
    std::string kind;  ///< small line above the title: "Half-space deviation"
    std::string title;
    std::string lead = {};  ///< one paragraph: what was asked
    std::optional<Verdict> answer = {};
    std::optional<DocumentTable> comparison = {};  ///< of those who answer
    std::string verdicts_heading = "Verdict";
    std::vector<Verdict> verdicts = {};
    /// Headings of the verdicts' table: of Verdict::subject and Verdict::effect.
    std::string judged = "assumption or comparison", consequence = "effect on what is measured";
    /// Beside answer and verdicts; empty: the first one of the sections.
    std::optional<Figure> figure = {};
    std::optional<Player> player = {};
    std::vector<std::pair<std::string, std::string>> settings = {};  ///< name, value with unit
    std::vector<DocumentSection> sections = {};                      ///< folded
    std::vector<std::pair<std::string, std::string>> files = {};     ///< text, path from the report
    std::string command = {};                                        ///< that makes it again
    std::string version = {};                                        ///< of the program
    std::string input = {};  ///< text of the resolved case, shown on a click
    /// Folder of ID.svg, ID.png and ID.csv of all figures, from the report; empty: the page makes
    /// them itself.
    std::string plots = {};
};

/// The verdicts with a subject as a table, failures first.
DocumentTable verdict_table(const Document& document);

/// All figures; their provenance is the document's version and command.
std::vector<Figure> figures_of(const Document& document);

/// Throws std::invalid_argument that names the figure or table whose id is no word or not its own,
/// or whose columns differ in length.
void check_document(const Document& document);

/// One HTML file that needs no network: verdicts, figures whose drawing (SVG) and data (CSV) can
/// be downloaded, tables that sort; light and dark, for screen, phone and paper. Texts are plain;
/// symbols of formulas in them ("f_T") are typeset. Same document, same bytes. Throws
/// what check_document throws.
std::string document_html(const Document& document);

}  // namespace tricontact::report
