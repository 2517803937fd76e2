# ERRORS.md, 2: a product below the normal range is off by at most the smallest subnormal number; where all of a
# direction is that small, what its prepared bound loses stays below 2^-600 times any functional in range.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

size = up(any_size);
radius = up(any_radius);
functional = up(any_functional);
needed = 3 * radius + 9b-52 * size;
product_up = up(x);
per_size_up up= (3 * radius + 9b-52 * size) * (1 + 1b-20);
product_dn = dn(x);
per_size_dn dn= (3 * radius + 9b-52 * size) * (1 + 1b-20);
product_zr = zr(x);
per_size_zr zr= (3 * radius + 9b-52 * size) * (1 + 1b-20);
product_ne = ne(x);
per_size_ne ne= (3 * radius + 9b-52 * size) * (1 + 1b-20);

{ |x| <= 1b-1021 /\
  size in [0, 1b-960] /\
  radius in [0, 1b-960] /\
  functional in [0, 1b400]
  ->
  |product_up - x| <= 1b-1074 /\ functional * (needed - per_size_up) <= 1b-601 /\
  |product_dn - x| <= 1b-1074 /\ functional * (needed - per_size_dn) <= 1b-601 /\
  |product_zr - x| <= 1b-1074 /\ functional * (needed - per_size_zr) <= 1b-601 /\
  |product_ne - x| <= 1b-1074 /\ functional * (needed - per_size_ne) <= 1b-601 }

needed - per_size_up -> (needed * (1 + 1b-20) - per_size_up) - needed * 1b-20;
needed - per_size_dn -> (needed * (1 + 1b-20) - per_size_dn) - needed * 1b-20;
needed - per_size_zr -> (needed * (1 + 1b-20) - per_size_zr) - needed * 1b-20;
needed - per_size_ne -> (needed * (1 + 1b-20) - per_size_ne) - needed * 1b-20;
