# ERRORS.md, 6: a function of window coordinates less its error. The exact magnitudes p, q, r of its terms add up to size,
# normalised to [1/2, 1]; where a bound less than size is proven, the error is at most a quarter of it. What is computed is
# off by at most 4 2^-52 <= 8 2^-52 size.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

error = up(any_error);
exact = ((p + q) + r) - error;
low_up up= ((p + q) + r) - error;
low_dn dn= ((p + q) + r) - error;
low_zr zr= ((p + q) + r) - error;
low_ne ne= ((p + q) + r) - error;

{ |p| <= 1 /\
  |q| <= 1 /\
  |r| <= 1 /\
  |p + q| <= 1 /\
  |(p + q) + r| <= 1 /\
  error in [0, 0.25]
  ->
  |low_up - exact| <= 4b-52 /\
  |low_dn - exact| <= 4b-52 /\
  |low_zr - exact| <= 4b-52 /\
  |low_ne - exact| <= 4b-52 }
