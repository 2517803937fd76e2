# ERRORS.md, 5: a component of a cross product of which neither exact product p, q exceeds s in magnitude, s
# normalised to [1, 2], is off by at most 4 2^-52 <= 5 2^-52 s.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

exact = p - q;
component_up up= p - q;
component_dn dn= p - q;
component_zr zr= p - q;
component_ne ne= p - q;

{ |p| <= 2 /\
  |q| <= 2
  ->
  |component_up - exact| <= 4b-52 /\
  |component_dn - exact| <= 4b-52 /\
  |component_zr - exact| <= 4b-52 /\
  |component_ne - exact| <= 4b-52 }
