# ERRORS.md, 3: the radius of a product, but for underflow. a and b are |value| of the operands, ra and rb their
# radii, v is |value| of the result. needed is normalised to [1/2, 1]; what is computed exceeds it by 2^-51.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

a = up(any_a);
b = up(any_b);
ra = up(any_ra);
rb = up(any_rb);
v = up(any_v);
needed = a * rb + (b + rb) * ra + 1b-52 * v;
radius_up up= (a * rb + (b + rb) * ra + 1b-52 * v) * (1 + 1b-48);
radius_dn dn= (a * rb + (b + rb) * ra + 1b-52 * v) * (1 + 1b-48);
radius_zr zr= (a * rb + (b + rb) * ra + 1b-52 * v) * (1 + 1b-48);
radius_ne ne= (a * rb + (b + rb) * ra + 1b-52 * v) * (1 + 1b-48);

{ a >= 0 /\
  b >= 0 /\
  ra >= 0 /\
  rb >= 0 /\
  a * rb in [0, 1] /\
  (b + rb) * ra in [0, 1] /\
  v in [0, 1b52] /\
  needed in [0.5, 1]
  ->
  radius_up - needed >= 1b-51 /\
  radius_dn - needed >= 1b-51 /\
  radius_zr - needed >= 1b-51 /\
  radius_ne - needed >= 1b-51 }

radius_up - needed -> (radius_up - needed * (1 + 1b-48)) + needed * 1b-48;
radius_dn - needed -> (radius_dn - needed * (1 + 1b-48)) + needed * 1b-48;
radius_zr - needed -> (radius_zr - needed * (1 + 1b-48)) + needed * 1b-48;
radius_ne - needed -> (radius_ne - needed * (1 + 1b-48)) + needed * 1b-48;
