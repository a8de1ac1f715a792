"""The Kalman recursion over any interval, in a form that never subtracts computed numbers."""
