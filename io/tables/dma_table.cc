#include "io/tables/dma_table.h"

#include <array>
#include <numbers>

#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::io {

namespace {

constexpr std::array<std::string_view, 3> names{"frequency", "G'", "G''"};

const CsvForm& dma_form() {
    // An analysis has dozens of rows.
    static const CsvForm form{"DMA table", "frequency [Hz], G' [MPa], G'' [MPa]", 1000,
                              "thin it out"};
    return form;
}

void check_dma_columns(const CsvTable& table) {
    const auto& columns = table.columns();
    for (std::size_t j = 0; j < columns.size() && j < names.size(); ++j)
        if (columns[j].name != names[j])
            table.refuse_header("the column " + toml_string(shortened(columns[j].heading, 40)) +
                                " should be " + std::string(names[j]));
    if (columns.size() != names.size())
        table.refuse_header("has " + std::to_string(columns.size()) + " columns instead of 3");
}

// From the table's unit to rad/s. "1/s" is used for both and says neither.
std::vector<double> angular_frequencies(const CsvTable& table) {
    const std::string unit = table.columns()[0].unit.value_or("Hz");
    if (unit.find("Hz") != std::string::npos || unit.find("hertz") != std::string::npos) {
        auto omega = table.values(names[0], Dimension::frequency);
        for (double& value : omega) value *= 2 * std::numbers::pi;
        return omega;
    }
    try {
        parse_quantity("1 " + unit, Dimension::angular_frequency);
    } catch (const QuantityError&) {
        table.refuse_header(toml_string(shortened(unit, 40)) +
                            " is neither a frequency in Hz nor one in rad/s");
    }
    return table.values(names[0], Dimension::angular_frequency);
}

contact::DmaTable dma_table_in(const CsvTable& table) {
    check_dma_columns(table);
    for (std::size_t k = 0; k < table.n_rows(); ++k)
        for (const auto& column : table.columns())
            if (!(column.values[k] > 0))
                table.refuse_value(k, column, "must be positive", "correct or remove the row");
    const auto& frequency = table.columns()[0];
    for (std::size_t k = 1; k < table.n_rows(); ++k)
        if (!(frequency.values[k] > frequency.values[k - 1]))
            table.refuse_value(k, frequency, "frequencies must increase from row to row",
                               "sort the table");
    return {.name = table.name(),
            .omega = angular_frequencies(table),
            .storage = table.values(names[1], Dimension::pressure),
            .loss = table.values(names[2], Dimension::pressure)};
}

}  // namespace

contact::DmaTable parse_dma_table(std::string_view text, const std::string& name) {
    return dma_table_in(CsvTable(text, name, dma_form()));
}

contact::DmaTable read_dma_table(const std::string& path) {
    return dma_table_in(read_csv_table(path, dma_form()));
}

}  // namespace tricontact::io
