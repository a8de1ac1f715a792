"""Work in other processes, and what is kept of it by stage."""
