"""What plots are made of: named columns, and the canvas of Matplotlib."""
