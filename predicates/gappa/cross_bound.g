# ERRORS.md, 5: the radius of a cross product, but for underflow. a and b are the sizes of the operands, ra and rb
# their radii. needed is normalised to [1/2, 1]; what is computed exceeds it by 2^-22.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

a = up(any_a);
b = up(any_b);
ra = up(any_ra);
rb = up(any_rb);
needed = 2 * (a * rb + ra * (b + rb)) + 5b-52 * a * b;
radius_up up= (2 * (a * rb + ra * (b + rb)) + 5b-52 * a * b) * (1 + 1b-20);
radius_dn dn= (2 * (a * rb + ra * (b + rb)) + 5b-52 * a * b) * (1 + 1b-20);
radius_zr zr= (2 * (a * rb + ra * (b + rb)) + 5b-52 * a * b) * (1 + 1b-20);
radius_ne ne= (2 * (a * rb + ra * (b + rb)) + 5b-52 * a * b) * (1 + 1b-20);

{ a in [1b-900, 1b400] /\
  b >= 0 /\
  ra >= 0 /\
  rb >= 0 /\
  a * rb in [0, 1] /\
  ra * (b + rb) in [0, 1] /\
  5b-52 * a * b in [0, 1] /\
  needed in [0.5, 1]
  ->
  radius_up - needed >= 1b-22 /\
  radius_dn - needed >= 1b-22 /\
  radius_zr - needed >= 1b-22 /\
  radius_ne - needed >= 1b-22 }

radius_up - needed -> (radius_up - needed * (1 + 1b-20)) + needed * 1b-20;
radius_dn - needed -> (radius_dn - needed * (1 + 1b-20)) + needed * 1b-20;
radius_zr - needed -> (radius_zr - needed * (1 + 1b-20)) + needed * 1b-20;
radius_ne - needed -> (radius_ne - needed * (1 + 1b-20)) + needed * 1b-20;
