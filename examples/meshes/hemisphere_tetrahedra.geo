// The half (y >= 0) of a hemisphere of hemisphere.geo again, of tetrahedra, as any geometry can be meshed:
// gmsh -3 hemisphere_tetrahedra.geo -o hemisphere_tetrahedra.msh
SetFactory("OpenCASCADE");
DefineConstant[ h = 0.8 ];  // tetrahedra at the contact
R = 10;   // radius
p = 4.2;  // half the side of the contact surface

Sphere(1) = {0, 0, R, R, -Pi/2, 0, Pi};
Box(2) = {-p, 0, -1, 2 * p, p, R + 1};
inner() = BooleanIntersection{ Volume{1}; }{ Volume{2}; };
outer() = BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; };
body() = BooleanFragments{ Volume{inner()}; Delete; }{ Volume{outer()}; Delete; };

e = 0.1;
q = 1.5 * p;  // boxes about curved surfaces are larger than these
low = R - Sqrt(R * R - 2 * p * p);
Physical Surface("contact") = Surface In BoundingBox{-q, -e, -e, q, q, low + e};
Physical Surface("support") = Surface In BoundingBox{-R - e, -e, R - e, R + e, R + e, R + e};
Physical Surface("symmetry") = Surface In BoundingBox{-R - e, -e, -e, R + e, e, R + e};
Physical Volume("body") = {body()};

// Each tetrahedron becomes four hexahedra, whose nodes lie on the sphere as those of the second order do.
Mesh.ElementOrder = 2;
Field[1] = Distance;
Field[1].SurfacesList = {Surface In BoundingBox{-q, -e, -e, q, q, low + e}};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = h;
Field[2].SizeMax = 4 * h;
Field[2].DistMin = 0;
Field[2].DistMax = R / 2;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
