// The contact as the run leaves it: with the indenter upright after the last period, at the end of
// a path, loaded.
#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

/// Of the last step.
template <double contact::StepRecord::*number>
QuantityValue at_end(const Subject& s) {
    return s.history.steps.empty() ? QuantityValue() : finite(s.history.steps.back().*number);
}

constexpr const char* of_springs =
    "always; of `mdr` and `mdr-layer` by the discs and rings that the springs stand for";

}  // namespace

constinit const Quantity end_normal_force{
    .key = "end_normal_force_N",
    .symbol = "F_N,end",
    .unit = "N",
    .name = "normal force at the end",
    .meaning =
        "Normal force at the end of the run; under a prescribed depth that after loading and "
        "rolling, with what friction changes in it.",
    .of = at_end<&contact::StepRecord::normal_force>,
    .part = Part::end_of_run,
    .is_refined = true};

constinit const Quantity end_indentation{
    .key = "end_indentation_m",
    .symbol = "d_end",
    .unit = "m",
    .name = "indentation at the end",
    .meaning = "Approach of the indenter at the end of the run.",
    .of = at_end<&contact::StepRecord::indentation>,
    .part = Part::end_of_run,
    .is_refined = true};

constinit const Quantity contact_area{.key = "contact_area_m2",
                                      .symbol = "A",
                                      .unit = "m2",
                                      .name = "contact area",
                                      .meaning = "Area in contact at the end of the run.",
                                      .defined = of_springs,
                                      .of = at_end<&contact::StepRecord::contact_area>,
                                      .part = Part::end_of_run,
                                      .is_refined = true,
                                      .is_counted = true};

constinit const Quantity stick_area{.key = "stick_area_m2",
                                    .symbol = "A_stick",
                                    .unit = "m2",
                                    .name = "area that sticks",
                                    .meaning = "Area that sticks in the last step of the run.",
                                    .defined = of_springs,
                                    .of = at_end<&contact::StepRecord::stick_area>,
                                    .part = Part::end_of_run,
                                    .is_refined = true,
                                    .is_counted = true};

constinit const Quantity slip_area{.key = "slip_area_m2",
                                   .symbol = "A_slip",
                                   .unit = "m2",
                                   .name = "area that slips",
                                   .meaning = "Area that slips in the last step of the run.",
                                   .defined = of_springs,
                                   .of = at_end<&contact::StepRecord::slip_area>,
                                   .part = Part::end_of_run,
                                   .is_refined = true,
                                   .is_counted = true};

constinit const Quantity stored_energy{
    .key = "stored_energy_J",
    .symbol = "E_el",
    .unit = "J",
    .name = "elastic energy",
    .meaning =
        "Elastic energy of the bodies at the end of the run: 1/2 ∫ (p u_z + tau u) dA of elastic "
        "ones, 2/5 F_N d in Hertz' contact.",
    .source = "Johnson (1985), 4.2",
    .of = at_end<&contact::StepRecord::stored_energy>,
    .part = Part::end_of_run,
    .is_refined = true};

constinit const Quantity friction_energy{
    .key = "friction_energy_J",
    .symbol = "D_all",
    .unit = "J",
    .name = "frictional work so far",
    .meaning = "Work of friction from the first touch to the end of the run.",
    .of = [](const Subject& s) -> QuantityValue {
        double work = 0;
        for (const contact::StepRecord& step : s.history.steps) work += step.dissipation;
        return s.history.steps.empty() ? QuantityValue() : finite(work);
    },
    .part = Part::end_of_run,
    .is_refined = true};

List of_end_of_run() {
    return {&end_normal_force, &end_indentation, &contact_area,   &stick_area,
            &slip_area,        &stored_energy,   &friction_energy};
}

}  // namespace tricontact::comparisons::quantities
