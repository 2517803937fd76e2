# ERRORS.md, 4: what a direction of this size and radius contributes to bounds, per unit of the functional's size and
# of its radius, but for underflow. Both needed values are normalised to [1/2, 1]; what is computed exceeds them by
# 2^-22.

@up = float<ieee_64, up>;
@dn = float<ieee_64, dn>;
@zr = float<ieee_64, zr>;
@ne = float<ieee_64, ne>;

size = up(any_size);
radius = up(any_radius);
needed_size = 3 * radius + 9b-52 * size;
needed_radius = 3 * (size + radius);
per_size_up up= (3 * radius + 9b-52 * size) * (1 + 1b-20);
per_radius_up up= 3 * (size + radius) * (1 + 1b-20);
per_size_dn dn= (3 * radius + 9b-52 * size) * (1 + 1b-20);
per_radius_dn dn= 3 * (size + radius) * (1 + 1b-20);
per_size_zr zr= (3 * radius + 9b-52 * size) * (1 + 1b-20);
per_radius_zr zr= 3 * (size + radius) * (1 + 1b-20);
per_size_ne ne= (3 * radius + 9b-52 * size) * (1 + 1b-20);
per_radius_ne ne= 3 * (size + radius) * (1 + 1b-20);

{ size in [0, 1b52] /\
  radius in [0, 1]
  ->
  (needed_size in [0.5, 1] -> per_size_up - needed_size >= 1b-22) /\ (needed_radius in [0.5, 1] -> per_radius_up - needed_radius >= 1b-22) /\
  (needed_size in [0.5, 1] -> per_size_dn - needed_size >= 1b-22) /\ (needed_radius in [0.5, 1] -> per_radius_dn - needed_radius >= 1b-22) /\
  (needed_size in [0.5, 1] -> per_size_zr - needed_size >= 1b-22) /\ (needed_radius in [0.5, 1] -> per_radius_zr - needed_radius >= 1b-22) /\
  (needed_size in [0.5, 1] -> per_size_ne - needed_size >= 1b-22) /\ (needed_radius in [0.5, 1] -> per_radius_ne - needed_radius >= 1b-22) }

per_size_up - needed_size -> (per_size_up - needed_size * (1 + 1b-20)) + needed_size * 1b-20;
per_radius_up - needed_radius -> (per_radius_up - needed_radius * (1 + 1b-20)) + needed_radius * 1b-20;
per_size_dn - needed_size -> (per_size_dn - needed_size * (1 + 1b-20)) + needed_size * 1b-20;
per_radius_dn - needed_radius -> (per_radius_dn - needed_radius * (1 + 1b-20)) + needed_radius * 1b-20;
per_size_zr - needed_size -> (per_size_zr - needed_size * (1 + 1b-20)) + needed_size * 1b-20;
per_radius_zr - needed_radius -> (per_radius_zr - needed_radius * (1 + 1b-20)) + needed_radius * 1b-20;
per_size_ne - needed_size -> (per_size_ne - needed_size * (1 + 1b-20)) + needed_size * 1b-20;
per_radius_ne - needed_radius -> (per_radius_ne - needed_radius * (1 + 1b-20)) + needed_radius * 1b-20;
