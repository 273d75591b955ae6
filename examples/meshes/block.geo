// Half (y >= 0) of a block of 60 mm x 60 mm x 5 mm, its surface in z = 0, in mm: hexahedra that tricontact reads as
// fem.mesh. Nothing of it matches hemisphere.geo. gmsh -3 block.geo -o block.msh
DefineConstant[ n = 7 ];  // elements in half the contact surface
w = 30;  // half the side
p = 4.3; // half the side of the contact surface
b = 5;   // thickness

// The base, in 3 x 2 pieces, which is moved up.
x[] = {-w, -p, p, w};
y[] = {0, p, w};
For j In {0:2}
  For i In {0:3}
    Point(10 * j + i + 1) = {x[i], y[j], -b};
  EndFor
EndFor
For j In {0:2}
  For i In {0:2}
    Line(100 + 10 * j + i) = {10 * j + i + 1, 10 * j + i + 2};
  EndFor
  Transfinite Curve {100 + 10 * j} = n + 1 Using Progression 1 / 1.3;
  Transfinite Curve {101 + 10 * j} = 2 * n + 1;
  Transfinite Curve {102 + 10 * j} = n + 1 Using Progression 1.3;
EndFor
For i In {0:3}
  Line(200 + i) = {i + 1, 11 + i};
  Line(210 + i) = {11 + i, 21 + i};
  Transfinite Curve {200 + i} = n + 1;
  Transfinite Curve {210 + i} = n + 1 Using Progression 1.3;
EndFor
contact = 0;
symmetry[] = {};
support[] = {};
body[] = {};
For j In {0:1}
  For i In {0:2}
    k = 3 * j + i + 1;
    Curve Loop(k) = {100 + 10 * j + i, 201 + 10 * j + i, -(110 + 10 * j + i), -(200 + 10 * j + i)};
    Plane Surface(k) = {k};
    Transfinite Surface {k};
    Recombine Surface {k};
    up[] = Extrude {0, 0, b} { Surface{k}; Layers{ {2, 2, 2}, {0.5, 0.8, 1} }; Recombine; };
    support[] += k;
    body[] += up[1];
    If (k == 2)
      contact = up[0];
    EndIf
    If (j == 0)
      symmetry[] += up[2];
    EndIf
  EndFor
EndFor

Physical Surface("contact") = {contact};
Physical Surface("support") = {support[]};
Physical Surface("symmetry") = {symmetry[]};
Physical Volume("body") = {body[]};
