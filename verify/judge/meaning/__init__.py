"""What a formula as read means: its symbols replaced by what they stand for, matrices, sums,
integrals and expectations worked out.
"""
