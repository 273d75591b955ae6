// Half (y >= 0) of a hemisphere of the radius R, in mm, its pole at the origin and its flat face above: hexahedra
// that tricontact reads as indenter.mesh. gmsh -3 hemisphere.geo -o hemisphere.msh
DefineConstant[ n = 7 ];  // elements in half the contact surface
R = 10;   // radius
p = 4.2;  // half the side of the contact surface
c = 3.6;  // half the side of the core, a box
low = 5;  // height of the core's lower face over the pole
e = R / Sqrt(2);

Point(1) = {0, 0, R};
// Core: lower corners 11 to 14, upper 21 to 24, from x = -c, y = 0 on around.
Point(11) = {-c, 0, low};  Point(12) = {c, 0, low};  Point(13) = {c, c, low};  Point(14) = {-c, c, low};
Point(21) = {-c, 0, R};    Point(22) = {c, 0, R};    Point(23) = {c, c, R};    Point(24) = {-c, c, R};
// Sphere: corners of the contact surface 31 to 34, the rim 41 to 44.
side = R - Sqrt(R * R - p * p);
corner = R - Sqrt(R * R - 2 * p * p);
Point(31) = {-p, 0, side}; Point(32) = {p, 0, side}; Point(33) = {p, p, corner}; Point(34) = {-p, p, corner};
Point(41) = {-R, 0, R};    Point(42) = {R, 0, R};    Point(43) = {e, e, R};      Point(44) = {-e, e, R};

For k In {1:4}
  next = k % 4 + 1;
  Line(10 + k) = {10 + k, 10 + next};
  Line(20 + k) = {20 + k, 20 + next};
  Line(50 + k) = {10 + k, 20 + k};                // up the core
  Line(60 + k) = {10 + k, 30 + k};                // from the core to the sphere
  Line(70 + k) = {20 + k, 40 + k};
  Circle(80 + k) = {30 + k, 1, 40 + k};           // up the sphere
EndFor
Point(39) = {0, 0, 0};
Circle(31) = {31, 1, 32};
Circle(32) = {32, 1, 33};  Circle(33) = {33, 1, 34};  Circle(34) = {34, 1, 31};
Circle(42) = {42, 1, 43};  Circle(43) = {43, 1, 44};  Circle(44) = {44, 1, 41};

// Faces: of the core, on the sphere, between both.
Curve Loop(1) = {11, 12, 13, 14};         Plane Surface(1) = {1};   // core, below
Curve Loop(2) = {21, 22, 23, 24};         Plane Surface(2) = {2};   // core, above
Curve Loop(3) = {31, 32, 33, 34};         Surface(3) = {3} In Sphere {1};  // contact
For k In {1:4}
  next = k % 4 + 1;
  Curve Loop(10 + k) = {10 + k, 50 + next, -(20 + k), -(50 + k)};  Plane Surface(10 + k) = {10 + k};
  Curve Loop(20 + k) = {10 + k, 60 + next, -(30 + k), -(60 + k)};  Surface(20 + k) = {20 + k};
  Curve Loop(40 + k) = {60 + k, 80 + k, -(70 + k), -(50 + k)};     Surface(40 + k) = {40 + k};
EndFor
For k In {2:4}
  next = k % 4 + 1;
  Curve Loop(50 + k) = {30 + k, 80 + next, -(40 + k), -(80 + k)};  Surface(50 + k) = {50 + k} In Sphere {1};
  Curve Loop(60 + k) = {20 + k, 70 + next, -(40 + k), -(70 + k)};  Plane Surface(60 + k) = {60 + k};
EndFor

Surface Loop(1) = {1, 2, 11, 12, 13, 14};  Volume(1) = {1};
Surface Loop(2) = {1, 3, 21, 22, 23, 24};  Volume(2) = {2};
For k In {2:4}
  next = k % 4 + 1;
  Surface Loop(10 + k) = {10 + k, 20 + k, 50 + k, 60 + k, 40 + k, 40 + next};  Volume(10 + k) = {10 + k};
EndFor

Transfinite Curve {11, 13, 21, 23, 31, 33, 43} = 2 * n + 1;
Transfinite Curve {12, 14, 22, 24, 32, 34, 42, 44} = n + 1;
Transfinite Curve {51, 52, 53, 54, 81, 82, 83, 84} = n + 1;
Transfinite Curve {61, 62, 63, 64, 71, 72, 73, 74} = n + 1 Using Progression 0.9;  // finer at the sphere
Transfinite Surface "*";
Recombine Surface "*";
Transfinite Volume "*";

Physical Surface("contact") = {3};
Physical Surface("support") = {2, 62, 63, 64};
Physical Surface("symmetry") = {11, 21, 41, 42};
Physical Volume("body") = {1, 2, 12, 13, 14};
