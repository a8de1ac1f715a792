"""Filter families, one file each: a model and the method that derives its steady state."""
