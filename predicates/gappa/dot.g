# ERRORS.md, 4: a dot product of which no exact product p, q, r exceeds s in magnitude, s normalised to [1, 2], is
# off by at most 9 2^-52 <= 9 2^-52 s.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

exact = (p + q) + r;
dot_up up= (p + q) + r;
dot_dn dn= (p + q) + r;
dot_zr zr= (p + q) + r;
dot_ne ne= (p + q) + r;

{ |p| <= 2 /\
  |q| <= 2 /\
  |r| <= 2
  ->
  |dot_up - exact| <= 9b-52 /\
  |dot_dn - exact| <= 9b-52 /\
  |dot_zr - exact| <= 9b-52 /\
  |dot_ne - exact| <= 9b-52 }
