#include "comparisons/shakedown/fit_rows.h"

#include "report/format.h"

namespace tricontact::comparisons {

namespace {

void add(std::vector<FitRow>& rows, const std::string& model, const std::string& group,
         const std::optional<FittedForm>& form) {
    if (form) rows.push_back({model, group, &*form});
}

}  // namespace

std::vector<FitRow> mapping_rows(const StudyFit& fit) {
    std::vector<FitRow> rows;
    for (const MappingGroup& group : fit.mapping) {
        add(rows, group.model, group.group, group.constant);
        add(rows, group.model, group.group, group.plane);
    }
    return rows;
}

std::vector<FitRow> ratcheting_rows(const StudyFit& fit) {
    std::vector<FitRow> rows;
    for (const RatchetingGroup& group : fit.ratcheting) {
        add(rows, group.model, group.group, group.limit);
        for (const RatchetingLoad& load : group.loads)
            add(rows, group.model,
                group.group + ", f_T = " + report::as_given(load.tangential_ratio), load.slope);
        add(rows, group.model, group.group, group.root);
        add(rows, group.model, group.group, group.root_of_eta);
    }
    return rows;
}

std::vector<FitRow> fit_rows(const StudyFit& fit) {
    std::vector<FitRow> rows = mapping_rows(fit);
    for (FitRow& row : ratcheting_rows(fit)) rows.push_back(std::move(row));
    return rows;
}

}  // namespace tricontact::comparisons
