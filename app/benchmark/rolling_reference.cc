#include "app/benchmark/rolling_reference.h"

#include <cmath>

#include "app/models/roll_models.h"
#include "benchmarks/reference/model_levels.h"
#include "benchmarks/reference/reference_kinds.h"
#include "comparisons/resolution/fineness.h"
#include "comparisons/resolution/refinement.h"
#include "contact/models/model_kind.h"
#include "files/digest.h"
#include "io/case/case_reader.h"

namespace tricontact::app {

namespace {

namespace keys = benchmarks::quantity_keys;
using benchmarks::EndState;
using benchmarks::Reference;

/// The steady state as the end of a path: what references make of it is the same.
EndState as_end(const rolling::RollingHistory& rolled) {
    const rolling::RollingState& steady = rolled.steady;
    EndState end{
        .size = rolled.surface.spacing[0], .history = {}, .scales = {}, .surface = rolled.surface};
    contact::StepRecord record;
    record.normal_force = steady.normal_force;
    record.tangential_force = steady.force;
    record.indentation = steady.indentation;
    record.contact_area = steady.contact_area;
    record.stick_area = steady.stick_area;
    end.history.steps = {record};
    end.scales.contact_radius = steady.half_length;
    end.scales.peak_pressure = steady.peak_pressure;
    return end;
}

}  // namespace

bool has_rolling_reference(const contact::Case& c) {
    return c.tractive_rolling && !benchmarks::has_carter(c) && !c.relaxation;
}

Reference rolling_reference(const contact::Case& c, int n_threads) {
    const std::string model = c.layer.thickness ? contact::models::bem_layer : contact::models::bem;
    Reference reference{.c = c, .digest = files::digest_of(io::write_case(c))};
    reference.geometry =
        c.is_line_contact() ? benchmarks::Geometry::plane : benchmarks::Geometry::spatial;
    std::vector<EndState> levels;
    std::vector<double> sizes, creepages;
    for (const double factor : {4., 2., 1.}) {
        contact::Case coarser = c;
        comparisons::change_resolution(coarser, contact::model_kind(model), {.coarser = factor});
        const auto run = roll(model, coarser, {.points = 0, .threads = n_threads});
        levels.push_back(as_end(run.history));
        sizes.push_back(levels.back().size);
        creepages.push_back(run.history.steady.creepage.longitudinal);
    }
    reference.models = {model};
    reference.values = benchmarks::values_of_levels(c, levels, model);
    // A path has these, a steady state has not.
    for (const char* key : {keys::shift, keys::dissipation, keys::stored_energy})
        reference.values.erase(key);
    const auto creepage = comparisons::estimate_limit(sizes, creepages);
    reference.values[keys::creepage] = {
        .value = creepage.value, .grid = creepage.error, .source = model};
    reference.contact_radius = reference.values.at(keys::contact_radius).value;
    reference.fields = benchmarks::fields_of_levels(levels);
    reference.has_tractions = true;
    const bool is_driven = c.tractive_rolling->longitudinal_creepage.has_value();
    reference.prescribed = {c.load.indentation ? keys::indentation : keys::normal_force,
                            is_driven ? keys::creepage : keys::tangential_force};
    for (const std::string& key : reference.prescribed)
        if (const auto found = reference.values.find(key); found != reference.values.end())
            found->second.grid = 0;
    reference.remarks = {"steady rolling towards +x; no other model is compared"};
    return reference;
}

}  // namespace tricontact::app
