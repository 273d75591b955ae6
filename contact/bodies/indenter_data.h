#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/bodies/elastic_body.h"
#include "contact/bodies/height_map.h"
#include "contact/bodies/profile_curve.h"
#include "contact/bodies/roughness.h"
#include "contact/substrates/material.h"

namespace tricontact::contact {

/// What a case says about its indenter, SI units. Lengths that a shape has not are 0.
struct IndenterData {
    /// Places in the table of shapes, see body_shapes(): those that other code asks for have a name
    /// here, further rows need none.
    enum class Shape : int {
        paraboloid,
        sphere,
        cylinder,
        roller,
        cone,
        power_law,
        rounded_punch,
        ellipsoid,
        profile,
        flat,
        height_map,
        flat_punch
    };
    /// Where the heights of a map's file point: away from the substrate, so that the lowest presses
    /// first, or out of the indenter's material, so that the highest does.
    enum class Heights { gap, outward };

    Shape shape = Shape::paraboloid;
    double radius = 0;       ///< R of curvature [m]; of an ellipsoid in the x-z plane
    double radius_y = 0;     ///< of an ellipsoid in the y-z plane [m]
    double length = 0;       ///< L along y of cylinder, roller and punches [m]; 0: of revolution
    double chamfer = 0;      ///< radius of the rounded ends of a roller [m]; 0: sharp
    double angle = 0;        ///< of a cone's flank to the surface [rad]
    double exponent = 0;     ///< n of the power law h = r^n / (n R^(n-1)) [-]
    double flat_radius = 0;  ///< of a punch's flat part [m]; its half width along y
    std::optional<std::string> file;  ///< of a profile or a height map
    std::optional<double> spacing;    ///< of a height map whose file does not say it [m]
    std::optional<double> unit;       ///< 1 of that file's heights [m]
    Heights heights = Heights::gap;   ///< of the file; those of `height_map` are gaps
    std::shared_ptr<const HeightMap> height_map;  ///< what the file holds
    std::vector<ProfileCurve::Point> profile;     ///< likewise
    std::optional<Roughness> roughness;           ///< upon the shape
    std::optional<Material> material;             ///< empty: rigid
    std::optional<ElasticBody> body;              ///< empty: as large as a half-space

    bool is_punch() const { return shape == Shape::rounded_punch || shape == Shape::flat_punch; }
    /// A punch along y, instead of one of revolution.
    bool is_long_punch() const { return is_punch() && length > 0; }
};

}  // namespace tricontact::contact
