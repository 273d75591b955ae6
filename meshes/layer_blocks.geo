// All that starts at a corner of the planes, upwards, has a tag by that corner: points, curves along
// x, surfaces across x and volumes that of the corner, curves along and surfaces across y and z
// `across_y` and `across_z` more.
step_y = #x[];
step_z = step_y * #y[];
across_y = step_z * #z[];
across_z = 2 * across_y;
For k In {0 : #z[] - 1}
  For j In {0 : #y[] - 1}
    For i In {0 : #x[] - 1}
      Point(1 + i + step_y * j + step_z * k) = {x[i], y[j], z[k]};
    EndFor
  EndFor
EndFor
For k In {0 : #z[] - 1}
  For j In {0 : #y[] - 1}
    For i In {0 : #x[] - 1}
      at = 1 + i + step_y * j + step_z * k;
      If (i < #x[] - 1)
        Line(at) = {at, at + 1};
        Transfinite Curve {at} = n_x[i] + 1 Using Progression ratio_x[i];
      EndIf
      If (j < #y[] - 1)
        Line(at + across_y) = {at, at + step_y};
        Transfinite Curve {at + across_y} = n_y[j] + 1 Using Progression ratio_y[j];
      EndIf
      If (k < #z[] - 1)
        Line(at + across_z) = {at, at + step_z};
        Transfinite Curve {at + across_z} = n_z[k] + 1 Using Progression ratio_z[k];
      EndIf
    EndFor
  EndFor
EndFor

contact[] = {}; free_top[] = {}; base[] = {}; sides[] = {}; symmetry[] = {};
For k In {0 : #z[] - 1}
  For j In {0 : #y[] - 1}
    For i In {0 : #x[] - 1}
      at = 1 + i + step_y * j + step_z * k;
      If (j < #y[] - 1 && k < #z[] - 1)
        Curve Loop(at) = {at + across_y, at + step_y + across_z,
                          -(at + step_z + across_y), -(at + across_z)};
        Plane Surface(at) = {at};
        If (i == 0 || i == #x[] - 1)
          sides[] += {at};
        EndIf
      EndIf
      If (k < #z[] - 1 && i < #x[] - 1)
        Curve Loop(at + across_y) = {at + across_z, at + step_z,
                                     -(at + 1 + across_z), -(at)};
        Plane Surface(at + across_y) = {at + across_y};
        If ((j == 0 && half_model) || (j == #y[] - 1 && slice))
          symmetry[] += {at + across_y};
        ElseIf (j == 0 || j == #y[] - 1)
          sides[] += {at + across_y};
        EndIf
      EndIf
      If (i < #x[] - 1 && j < #y[] - 1)
        Curve Loop(at + across_z) = {at, at + 1 + across_y,
                                     -(at + step_y), -(at + across_y)};
        Plane Surface(at + across_z) = {at + across_z};
        If (k == 0)
          base[] += {at + across_z};
        ElseIf (k == #z[] - 1 && i == patch_i && j >= patch_j && j <= last_patch_j)
          contact[] += {at + across_z};
        ElseIf (k == #z[] - 1)
          free_top[] += {at + across_z};
        EndIf
      EndIf
    EndFor
  EndFor
EndFor

layer[] = {}; lower_layer[] = {};
For k In {0 : #z[] - 2}
  For j In {0 : #y[] - 2}
    For i In {0 : #x[] - 2}
      at = 1 + i + step_y * j + step_z * k;
      Surface Loop(at) = {at, at + 1, at + across_y, at + step_y + across_y,
                          at + across_z, at + step_z + across_z};
      Volume(at) = {at};
      If (k == #z[] - 2)
        layer[] += {at};
      Else
        lower_layer[] += {at};
      EndIf
    EndFor
  EndFor
EndFor
Transfinite Surface "*";
Recombine Surface "*";
Transfinite Volume "*";

Physical Surface("contact", 1) = contact[];
If (#free_top[] > 0)
  Physical Surface("free_top", 2) = free_top[];
EndIf
Physical Surface("base", 3) = base[];
Physical Surface("sides", 4) = sides[];
If (#symmetry[] > 0)
  Physical Surface("symmetry", 5) = symmetry[];
EndIf
Physical Volume("layer", 1) = layer[];
If (#lower_layer[] > 0)
  Physical Volume("lower_layer", 2) = lower_layer[];
EndIf
