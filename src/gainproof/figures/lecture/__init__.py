"""The pictures of the lecture on tracking filters, drawn anew from kernels and seeded noise.

Of the lecture's pictures we have captions and labels alone. What they leave open is chosen here, in
`scene` and in the notes of each table, and said on the sheet and in its files.
"""
