## -*- texinfo -*-
## @deftypefn {} {@var{fields} =} joint_fields ()
## All fields of a joint, a row each: name, default, kind (see @code{value_error}).  A joint's kind says which of them
## count, see @code{joint_kinds}.
## @end deftypefn

function fields = joint_fields ()
  fields = {
    "name",      "",      "text"
    "kind",      NaN,     ["\"" strjoin({joint_kinds().name}, "\", \"") "\""]
    "bodies",    NaN,     "vector of one or two numbers of bodies, 0 for the ground"
    "stations",  [],      "vector of stations in m, one a body"
    "point",     [0 0],   "vector [x y] of a place on the ground in m"
    "direction", 0,       "number in rad"
    "value",     0,       "vector or function of t, see joint_kinds"
    "stiffness", 0,       "nonnegative number in N/m or N m/rad"
    "damping",   0,       "nonnegative number in N s/m or N m s/rad"
    "rest",      0,       "number in m or rad"
  };
endfunction

%!assert (columns (joint_fields ()), 3)
