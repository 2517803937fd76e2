# ERRORS.md, 4: the bound of a dot product from prepared contributions, but for underflow. needed is normalised to
# [1/2, 1]; what is computed is short of it by 2^-51 at most, which the contributions' surplus of 2^-22 outweighs.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

size = up(any_size);
radius = up(any_radius);
per_size = up(any_per_size);
per_radius = up(any_per_radius);
needed = size * per_size + radius * per_radius;
bound_up up= size * per_size + radius * per_radius;
bound_dn dn= size * per_size + radius * per_radius;
bound_zr zr= size * per_size + radius * per_radius;
bound_ne ne= size * per_size + radius * per_radius;

{ size * per_size in [0, 1] /\
  radius * per_radius in [0, 1] /\
  needed in [0.5, 1]
  ->
  bound_up - needed >= -1b-51 /\
  bound_dn - needed >= -1b-51 /\
  bound_zr - needed >= -1b-51 /\
  bound_ne - needed >= -1b-51 }
