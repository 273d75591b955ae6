#include <fmt/format.h>

#include <iostream>

#include "app/boundary_element_model.h"
#include "app/commands/commands.h"
#include "bem/case_compliance.h"
#include "bem/influence_file.h"
#include "io/results/atomic_file.h"
#include "io/results/output_target.h"

namespace tricontact::app {

void influence_command(const InfluenceOptions& options) {
    const auto read = read_boundary_elements(options.case_file, options.overrides, options.model);
    io::check_output_file(options.output, bem::influence_file_title);
    const auto table = bem::case_influence(
        read.c, options.threads, read.is_layer() ? bem::Body::layer : bem::Body::half_space);
    io::write_file(options.output, bem::influence_text(table));
    std::cout << fmt::format(
        "model                {}\n"
        "spacing              {:.6g} mm\n"
        "positions            {} x {}\n"
        "written              {}\n",
        read.model, 1e3 * table.spacing, table.n_x, table.n_y, options.output);
}

}  // namespace tricontact::app
