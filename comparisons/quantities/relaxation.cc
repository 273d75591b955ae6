#include <algorithm>

#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/relaxation_study.h"

namespace tricontact::comparisons::quantities {

namespace {

QuantityValue of_drive(const Subject& s, double DriveValues::*member) {
    const auto drive = drive_values(s.c, s.history.amplitude);
    return drive ? finite((*drive).*member) : QuantityValue();
}

constexpr const char* relaxing = "with rolling on a relaxing substrate at a finite speed";

constinit const Quantity largest_deborah_number{
    .key = "largest_deborah_number",
    .symbol = "De",
    .name = "largest Deborah number",
    .meaning = "2 pi f tau of the slowest branch.",
    .defined = relaxing,
    .of = [](const Subject& s) -> QuantityValue {
        const auto drive = drive_values(s.c, s.history.amplitude);
        if (!drive) return {};
        return finite(*std::ranges::max_element(drive->deborah));
    }};

}  // namespace

constinit const Quantity frequency{
    .key = "frequency_Hz",
    .symbol = "f",
    .unit = "Hz",
    .name = "frequency",
    .meaning = "Periods per time, v/(4 W).",
    .defined = relaxing,
    .of = [](const Subject& s) { return of_drive(s, &DriveValues::frequency); }};

constinit const Quantity storage_modulus{
    .key = "storage_modulus_Pa",
    .symbol = "G'",
    .unit = "Pa",
    .name = "storage modulus",
    .meaning = "In-phase shear modulus of the substrate at the frequency of the rolling.",
    .defined = relaxing,
    .of = [](const Subject& s) { return of_drive(s, &DriveValues::storage); }};

constinit const Quantity loss_modulus{
    .key = "loss_modulus_Pa",
    .symbol = "G''",
    .unit = "Pa",
    .name = "loss modulus",
    .meaning = "Out-of-phase shear modulus of the substrate at the frequency of the rolling.",
    .defined = relaxing,
    .of = [](const Subject& s) { return of_drive(s, &DriveValues::loss); }};

List of_relaxation() {
    return {&frequency, &storage_modulus, &loss_modulus, &largest_deborah_number};
}

}  // namespace tricontact::comparisons::quantities
