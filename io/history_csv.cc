#include "io/history_csv.h"

#include "io/history_columns.h"
#include "io/messages.h"

namespace tricontact::io {

std::string history_csv(const contact::History& history) {
    const auto number = [](const auto* place) { return shortest(*place); };
    std::string out = "step";
    for (const HistoryColumn& column : history_columns()) out.append(",").append(column.name);
    out += '\n';
    for (std::size_t i = 0; i < history.steps.size(); ++i) {
        out += std::to_string(i);
        for (const HistoryColumn& column : history_columns())
            out.append(",").append(std::visit(number, column.place(history.steps[i])));
        out += '\n';
    }
    return out;
}

}  // namespace tricontact::io
