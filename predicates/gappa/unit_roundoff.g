# ERRORS.md, 1: in any rounding mode the result of one operation is off by at most 2^-52 of the exact result,
# where that is not subnormal; sums and differences of float64 numbers need no such condition.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

a = up(any_a);
b = up(any_b);
product_up = up(x);
sum_up = up(a + b);
product_dn = dn(x);
sum_dn = dn(a + b);
product_zr = zr(x);
sum_zr = zr(a + b);
product_ne = ne(x);
sum_ne = ne(a + b);

{ |x| in [1b-1021, 1b1000]
  ->
  |product_up -/ x| <= 1b-52 /\ |sum_up -/ (a + b)| <= 1b-52 /\
  |product_dn -/ x| <= 1b-52 /\ |sum_dn -/ (a + b)| <= 1b-52 /\
  |product_zr -/ x| <= 1b-52 /\ |sum_zr -/ (a + b)| <= 1b-52 /\
  |product_ne -/ x| <= 1b-52 /\ |sum_ne -/ (a + b)| <= 1b-52 }
