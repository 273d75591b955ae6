#include <algorithm>

#include "contact/bodies/upper_plate.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"
#include "io/case/case_keys.h"
#include "io/results/output.h"

// The plate above a body between two that are not alike: its keys, and what goes with it.

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ElasticBody;
using contact::Material;
using contact::UpperPlate;

Field rigid_plate(Case& c) {
    const auto* const plate = c.kept.find<UpperPlate>();
    return plate && plate->is_rigid ? Field(&c.of<UpperPlate>().is_rigid) : Field();
}
/// Of a plate that deforms.
template <auto... members>
Field of_plate(Case& c) {
    const auto* const plate = c.kept.find<UpperPlate>();
    return plate && !plate->is_rigid ? in(c.of<UpperPlate>(), members...) : Field();
}

void check_plate_alone(const UpperPlate& plate, const Document& document) {
    for (const char* key : {"upper_plate.young", "upper_plate.poisson", "upper_plate.thickness"})
        if (plate.is_rigid && document.find(key))
            refuse(document, key, "a rigid plate has neither material nor thickness",
                   "omit it, or omit upper_plate.rigid");
}

/// The key that [upper_plate] begins with.
std::string first_key(const Document& document) {
    return used(document, "upper_plate.rigid", "upper_plate.young");
}

}  // namespace

std::vector<CaseKey> upper_plate_keys() {
    return {
        {boolean_key("upper_plate.rigid", "true",
                     "the plate above a body between two plates is rigid, unlike the substrate"),
         rigid_plate},
        {modulus_key("upper_plate.young", R"("5.2 MPa")",
                     "Young's modulus of that plate, a layer bonded to rigid ground; without "
                     "[upper_plate] both plates are like the substrate",
                     {.required = true}),
         of_plate<&UpperPlate::material, &Material::young>},
        {poisson_key("upper_plate.poisson", "0.3", "its Poisson's ratio", {.required = true}),
         of_plate<&UpperPlate::material, &Material::poisson>},
        {length_key("upper_plate.thickness", R"("8 mm")", "its thickness", {.required = true}),
         of_plate<&UpperPlate::thickness>}};
}

void make_upper_plate(Case& c, const Document& document) {
    if (!document.find_section("upper_plate")) return;
    c.of<UpperPlate>().is_rigid = document.find("upper_plate.rigid");  // until it is read
}

void check_upper_plate(const Case& c, const Document& document) {
    const UpperPlate* const plate = c.kept.find<UpperPlate>();
    if (!plate) return;
    const std::string key = first_key(document);
    check_plate_alone(*plate, document);
    if (!c.indenter.body || c.indenter.body->support != ElasticBody::Support::plates)
        refuse(document, key, "no body of the case lies between two plates",
               "omit [upper_plate], or take indenter.support = \"plates\"");
    if (c.contact.coupling)
        refuse(document, "contact.coupling",
               "between unlike plates bodies are pressed without friction: what slips at one "
               "plate would move the surface at the other",
               "omit it, or omit [upper_plate]");
    for (const std::string& model : c.models)
        if (model == contact::models::fem)
            refuse(document, "models", model + " presses a body between plates that are alike",
                   "take fem-axisymmetric or fem-plane, or omit [upper_plate]");
    if (c.relaxation)
        refuse(document, key, "unlike plates are elastic",
               "omit [substrate.relaxation] or [upper_plate]");
    if (c.interface.is_elastic())
        refuse(document, key, "unlike plates have no springs of an interface",
               "omit [interface] or [upper_plate]");
    if (document.find_section("wear"))
        refuse(document, key, "surfaces between unlike plates do not wear",
               "omit [wear] or [upper_plate]");
    if (c.of<Output>().volume != Output::Volume::none)
        refuse(document, "output.volume", "the inside of a body between unlike plates is not shown",
               "omit it, or omit [upper_plate]");
    for (const char* section : {"record", "measurement", "design"})
        if (document.find_section(section))
            refuse(document, key, "experiments are about bodies on one substrate",
                   "omit [upper_plate], or leave out the sections of experiments");
}

}  // namespace tricontact::io
