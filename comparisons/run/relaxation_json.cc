// The relaxing substrate's section of summary.json.

#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/quantities/quantities.h"
#include "comparisons/run/relaxation_report.h"
#include "contact/relaxing_case.h"
#include "io/case/case_input.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using json = nlohmann::ordered_json;

json drive_json(const DriveValues& drive) {
    return {{quantities::amplitude.key, drive.amplitude},
            {quantities::frequency.key, drive.frequency},
            {quantities::storage_modulus.key, drive.storage},
            {quantities::loss_modulus.key, drive.loss},
            {"loss_tangent", drive.loss_tangent()},
            {"deborah_numbers", drive.deborah}};
}

json elastic_json(const RunValues& elastic) {
    return {{"elastic_state", elastic.state ? json(contact::name_of(*elastic.state)) : json()},
            {"elastic_static_shift_m", elastic.static_shift},
            {"elastic_final_shift_m", elastic.final_shift},
            {"elastic_shift_increment_m", elastic.increment},
            {"elastic_limit_tangential_ratio", elastic.limit}};
}

json twin_json(const TwinComparison& twin) {
    return {{"drive", twin.drive ? drive_json(*twin.drive) : json()},
            {"elastic_twin", twin.other ? elastic_json(*twin.other) : json()},
            {"why_no_twin", twin.other ? json() : json(twin.why_none)},
            {"static_shift_error", twin.static_error()},
            {"final_shift_error", twin.final_error()},
            {"settled_shift_error", twin.settled_error()},
            {"increment_error", twin.increment_error()},
            {"limit_tangential_ratio_error", twin.limit_error()}};
}

json limit_json(const std::optional<SpeedLimit>& limit) {
    if (!limit) return nullptr;
    return {{"model", limit->model},
            {"quantity", limit->of_increment ? "shift_increment" : "final_shift"},
            {"error", SpeedLimit::limit},
            {"speed_m_per_s", limit->speed},
            {"limit_frequency_Hz", limit->frequency},
            {"resolution", SpeedLimit::resolution},
            {"slowest_m_per_s", limit->slowest},
            {"fastest_m_per_s", limit->fastest},
            {"runs", limit->runs},
            {"why_none", limit->speed ? json() : json(limit->why_none)}};
}

json fit_json(const Case& c) {
    const auto& fit = io::relaxation_fits(c).dma;
    if (!fit) return nullptr;
    return {{"table", fit->table.name},
            {"rows", fit->table.size()},
            {"relaxed_shear_modulus_Pa", fit->relaxed_modulus},
            {"storage_residual_rms", fit->storage_rms},
            {"loss_residual_rms", fit->loss_rms},
            {"worst_residual", fit->worst.residual},
            {"worst_frequency_Hz", fit->worst.omega / (2 * std::numbers::pi)},
            {"worst_of", fit->worst.loss ? "loss" : "storage"},
            {"remarks", contact::remarks(*fit, contact::relaxing_material(c).shear_modulus())}};
}

json test_json(const Case& c) {
    const auto& fit = io::relaxation_fits(c).test;
    if (!fit) return nullptr;
    const bool young = fit->table.is_young;
    return {
        {"table", fit->table.name},
        {"rows", fit->table.size()},
        {"modulus", fit->table.symbol()},
        {"relaxed_modulus_Pa", fit->relaxed_modulus},
        {"residual_rms", fit->rms},
        {"worst_residual", fit->worst_residual},
        {"worst_time_s", fit->worst_time},
        {"remarks", contact::remarks(*fit, young ? contact::relaxing_material(c).young
                                                 : contact::relaxing_material(c).shear_modulus())}};
}

}  // namespace

json relaxation_json(const Case& c, const RelaxationStudy& study) {
    json models = json::object();
    for (const TwinComparison& twin : study.twins) models[twin.model] = twin_json(twin);
    const double relaxed = contact::relaxing_material(c).shear_modulus();
    const auto branch_json = [&](const auto& branch) -> json {
        return {{"shear_modulus_Pa", relaxed * branch.ratio}, {"time_s", branch.time}};
    };
    return {{"relaxed_shear_modulus_Pa", relaxed},
            {"instantaneous_shear_modulus_Pa", relaxed * c.relaxation->instantaneous_ratio()},
            {"branches", report::list_of(c.relaxation->branches, branch_json)},
            {"models", models},
            {"elastic_up_to", limit_json(study.limit)},
            {"dma_fit", fit_json(c)},
            {"test_fit", test_json(c)}};
}

}  // namespace tricontact::comparisons
