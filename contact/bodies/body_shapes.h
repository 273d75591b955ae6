#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/bodies/indenter_data.h"

namespace tricontact::contact {

/// A row of the table of shapes. Whoever adds a body writes its class and adds its row at the end:
/// case files, models and reports follow.
struct BodyShape {
    using Data = IndenterData;

    std::string_view word;               ///< of indenter.shape in case files
    const char* title;                   ///< for readers
    std::vector<std::string_view> keys;  ///< of [indenter] that it takes, beside those of all
    /// Makes the smooth body of a row that has one: of revolution, or ...
    std::unique_ptr<AxisymmetricIndenter> (*of_revolution)(const Data&) = nullptr;
    std::unique_ptr<Indenter> (*other)(const Data&) = nullptr;  ///< ... any other.
    /// Where the pressure at the centre is infinite; null: nowhere.
    bool (*has_conical_tip)(const Data&) = nullptr;
    /// Where the pressure is known to fall from the centre on; null: nowhere.
    bool (*pressure_falls)(const Data&) = nullptr;

    std::unique_ptr<Indenter> make(const Data& data) const {
        return of_revolution ? of_revolution(data) : other(data);
    }
};

/// In the order of IndenterData::Shape.
std::span<const BodyShape> body_shapes();
const BodyShape& body_shape(IndenterData::Shape shape);

/// A body of revolution or an ellipsoid, without roughness: symmetric in
/// x and in y.
bool is_smooth_ball(const IndenterData& body);

}  // namespace tricontact::contact
