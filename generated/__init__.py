"""Kernels that need NumPy only, printed from derivations with proved error bounds.

- `acceleration_increments`: Acceleration increments (acceleration random walk): steady state
  with measured position.
- `alpha_beta_gamma`: Alpha-beta-gamma filters with any gains.
- `alpha_beta`: Alpha-beta filters with any gains.
- `bearings_only`: Bearings and elevations of targets from stations.
- `continuous_white_acceleration`: Continuous white acceleration: steady state with measured
  position.
- `continuous_white_jerk`: Continuous white jerk: steady state with measured position.
- `converted_measurements`: Converted measurements: range and angles made Cartesian, with their
  noise.
- `filter_step`: One step of filters with fixed gains.
- `interacting_gains`: Filters with matrix gains: the gain of one coordinate.
- `least_squares_line`: Least-squares line (growing memory): gains by sample number.
- `least_squares_mean`: Least-squares mean (growing memory): gains by sample number.
- `least_squares_parabola`: Least-squares parabola (growing memory): gains by sample number.
- `multipath_location`: Location from range and Doppler in multipath: the deviation of an
  estimated bias.
- `polar_coordinates`: Polar coordinates: range, elevation and bearing from north.
- `position_velocity_random_acceleration`: Position and velocity measured, random acceleration
  (constant over each interval).
- `position_velocity_random_velocity`: Position and velocity measured, random velocity (velocity
  random walk).
- `position_velocity`: Position and velocity measured, continuous white acceleration.
- `random_acceleration`: Random acceleration (constant over each interval): steady state with
  measured position.
- `random_jerk`: Random jerk (constant over each interval): steady state with measured position.
- `random_velocity`: Random velocity (velocity random walk): steady state with measured
  position.
- `range_doppler`: Range and Doppler of moving targets from moving stations.
- `recursion_three_states`: Kalman recursion of position, velocity and acceleration, any
  intervals.
- `recursion_two_states`: Kalman recursion of position and velocity, any intervals.
- `updated_gains`: Gains that follow the tracking index to first order.
- `wiener_acceleration`: Discrete Wiener process acceleration: steady state with measured
  position.
"""
