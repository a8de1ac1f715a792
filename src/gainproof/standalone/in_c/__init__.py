"""What a package with C has besides: its kernels' arithmetic in C, once that is compiled."""
