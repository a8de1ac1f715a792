"""What is copied beside the printed kernels: NumPy and these files alone, no more of ours."""
