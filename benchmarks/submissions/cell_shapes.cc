#include "benchmarks/submissions/cell_shapes.h"

namespace tricontact::benchmarks {

namespace {

const CellShape tetrahedron_shape{3,
                                  4,
                                  {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}},
                                  {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
const CellShape hexahedron_shape{
    3,
    8,
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}},
    {{0, 1},
     {1, 2},
     {2, 3},
     {3, 0},
     {4, 5},
     {5, 6},
     {6, 7},
     {7, 4},
     {0, 4},
     {1, 5},
     {2, 6},
     {3, 7}}};
const CellShape voxel_shape{
    3, 8, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}, {}};
const CellShape wedge_shape{
    3,
    6,
    {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}},
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
const CellShape pyramid_shape{3,
                              5,
                              {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                              {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};
const CellShape triangle_shape{2, 3, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1}, {1, 2}, {2, 0}}};
const CellShape quadrilateral_shape{
    2, 4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
const CellShape pixel_shape{2, 4, {{0, 1}, {1, 3}, {3, 2}, {2, 0}}, {}};
const CellShape line_shape{1, 2, {}, {}};
const CellShape point_shape{0, 1, {}, {}};
const CellShape unread_shape{};

}  // namespace

const CellShape& cell_shape(std::uint8_t type) {
    switch (type) {
        case 1:
        case 2:
            return point_shape;
        case 3:
        case 4:
        case 21:
        case 68:
            return line_shape;
        case 5:
        case 22:
        case 34:
        case 69:
            return triangle_shape;
        case 7:
        case 6:
        case 9:
        case 23:
        case 28:
        case 70:
            return quadrilateral_shape;
        case 8:
            return pixel_shape;
        case 10:
        case 24:
        case 71:
            return tetrahedron_shape;
        case 11:
            return voxel_shape;
        case 12:
        case 25:
        case 29:
        case 33:
        case 72:
            return hexahedron_shape;
        case 13:
        case 26:
        case 32:
        case 73:
            return wedge_shape;
        case 14:
        case 27:
            return pyramid_shape;
        default:
            return unread_shape;
    }
}

bool is_quadratic(std::uint8_t type) {
    return type >= 21 && type <= 29;
}

}  // namespace tricontact::benchmarks
